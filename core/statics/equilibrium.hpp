// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>

namespace contactsim {

/// Forces that a solver brings to balance by moving what they act on. Vectors hold all unknowns: the
/// displacement increments of all nodes, then their rotations where nodes turn [3 n_nodes or 6 n_nodes].
class Equilibrium {
 public:
  virtual ~Equilibrium() = default;

  /// Sets the forces that nothing balances at an increment; those of fixed and prescribed directions are 0.
  /// Returns false where there are none, such as in elements that have turned inside out.
  ///   increment  since the start of the step [length], [1]
  ///   residual   [force], [force length]
  virtual bool evaluate(const Eigen::VectorXd& increment, Eigen::VectorXd& residual) = 0;

  /// The size of a residual, forces and moments together [force].
  virtual double norm(const Eigen::VectorXd& residual) const { return residual.norm(); }
  /// What sizes of residuals are compared with, of the last evaluation [force].
  virtual double reference() const = 0;
  /// The size of a residual that round-off makes of one that is none, of the last evaluation [force].
  virtual double round_off() const { return 0.0; }
  /// The largest factor by which a direction is still small enough for the difference of two residuals to be
  /// a derivative [1].
  virtual double probe_factor(const Eigen::VectorXd& direction) const = 0;
  /// The largest factor by which a search may go along a direction in one trial [1].
  virtual double longest_step(const Eigen::VectorXd& /*direction*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Whether forces come and go with small motions, as those of contact do: the rough part.
  virtual bool is_rough() const { return false; }
  /// Has the rough part push as it did in the last evaluation, whatever moves from now on; or lets it follow.
  virtual void hold_rough(bool /*does*/) {}
  /// Has friction of the rough part slide at the forces that what presses in the last evaluation gives,
  /// whatever presses from now on, or lets it follow what presses. Returns whether any is held.
  virtual bool hold_slip_limits(bool /*does*/) { return false; }
  /// Adds to a vector what the rough part resists a direction with where the last find_springs() was, with no
  /// part that its large forces soften: far from balance steps by its derivative lead nowhere.
  virtual void add_springs(const Eigen::VectorXd& /*direction*/, Eigen::VectorXd& /*product*/) const {}
  /// Finds the springs of the last evaluation.
  virtual void find_springs() {}
  /// What makes forces of residuals, of which norm() is the size: 1, and 1/length of moments.
  virtual Eigen::VectorXd scales(Eigen::Index size) const { return Eigen::VectorXd::Ones(size); }
  /// Takes out of a vector what lies along fixed and prescribed directions.
  virtual void project(Eigen::VectorXd& /*vector*/) const {}
};

/// Something near the inverse of the stiffness, symmetric and positive.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// Sets z to the increment that a residual asks for.
  virtual void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const = 0;
  /// Has apply() follow the stiffness that is known of now where it still has an earlier one. Returns whether
  /// it had.
  virtual bool catch_up() { return false; }
  /// What it holds unknowns to the ground with, which the residual does not have; null: nothing.
  virtual const Eigen::VectorXd* ground() const { return nullptr; }
};

}  // namespace contactsim
