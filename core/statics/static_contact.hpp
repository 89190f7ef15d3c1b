// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/elements/force_term.hpp"

namespace contactsim {

/// A node of the mesh that a corner of a spring moves with.
struct SpringEnd {
  std::uint32_t node = 0;   ///< of the mesh
  bool turns = false;       ///< by its rotation; else by its displacement
  std::uint8_t corner = 0;  ///< of the spring
  Eigen::Matrix3d share;    ///< by what its motion moves the corner [1], of rotations [length]
};

/// What contact resists small motions with at a contact point, over the overlap of two faces, or where
/// something is tied: the force on corner i is the sum over j of - coupling(i, j) stiffness u_j.
struct ContactSpring {
  static constexpr std::size_t max_corners = 8;

  std::vector<SpringEnd> ends;
  Eigen::Matrix<double, 8, 8> coupling;  ///< symmetric, without negative eigenvalues [1] or [length^2]
  Eigen::Matrix3d stiffness;             ///< symmetric [force/length] over the dimension of coupling
  /// Beside it what friction that slides resists pressure with, which is not symmetric; the same dimensions.
  Eigen::Matrix3d unsymmetric = Eigen::Matrix3d::Zero();

  /// Calls take(end a, end b, block) with the symmetric stiffness between the motions of every two ends.
  template <class Take>
  void visit_blocks(const Take& take) const {
    for (const SpringEnd& a : ends) {
      const Eigen::Matrix3d force = a.share.transpose() * stiffness;
      for (const SpringEnd& b : ends) {
        const double factor = coupling(a.corner, b.corner);
        if (factor != 0.0) take(a, b, Eigen::Matrix3d(factor * force * b.share));
      }
    }
  }
  /// Adds all of the stiffness times the motions of the ends to what the ends feel.
  ///   motion_of(end)   [3]
  ///   add(end, felt)
  template <class MotionOf, class Add>
  void multiply(const MotionOf& motion_of, const Add& add) const {
    Eigen::Matrix<double, 3, max_corners> moved = Eigen::Matrix<double, 3, max_corners>::Zero();
    for (const SpringEnd& end : ends) moved.col(end.corner) += end.share * motion_of(end);
    const Eigen::Matrix<double, 3, max_corners> felt = (stiffness + unsymmetric) * moved * coupling;
    for (const SpringEnd& end : ends) add(end, Eigen::Vector3d(end.share.transpose() * felt.col(end.corner)));
  }
};

/// What an update of multipliers came to.
struct MultiplierChange {
  double change = 0.0;     ///< size of the change of the forces of contact [force]
  double reference = 0.0;  ///< size of these forces [force]
};

/// How much stabilization a load step has.
struct StabilizationLevel {
  double ramp = 0.0;     ///< 1 as its time stepping block begins, 0 as it ends [1]
  double n_steps = 1.0;  ///< of such a size in the block [1]
};

/// What resists the motion of sides that do not touch yet.
struct Stabilization {
  double share = 0.0;                ///< the largest of the stiffness behind faces, of the step [1]
  std::vector<std::uint32_t> nodes;  ///< of the mesh that it acts on, each once or more
};

/// Contact whose forces are asked for again and again until a load step has found equilibrium: nothing that a
/// trial finds is remembered.
class StaticContact {
 public:
  virtual ~StaticContact() = default;

  /// Begins a load step.
  ///   motion  its time and size; the coordinates are still those of its start, where nothing moves
  virtual void begin_trials(const Motion& motion) = 0;
  /// Sets the forces of contact after a motion from the start of the step. Throws SolveError.
  ///   forces, moments  [3 x n_nodes] [force] [force length]; the latter null where no node turns
  virtual void try_forces(const Motion& motion, Eigen::Matrix3Xd& forces, Eigen::Matrix3Xd* moments) = 0;
  /// Has weighted nodes of faces, and nodes that meet faces, which the last trial presses slide at the limits
  /// which that gives, whatever presses them in the trials that follow, or lets the limits follow what
  /// presses. Returns whether any are held.
  virtual bool hold_slip_limits(bool does) = 0;
  /// Calls take(spring) for all that held in the last trial.
  virtual void visit_springs(const std::function<void(const ContactSpring&)>& take) const = 0;
  /// Adds what penetrates in the last trial to the multipliers, unless that changes the forces of contact by
  /// less than a tolerance.
  ///   tolerance  of their size [1]
  virtual MultiplierChange update_multipliers(double tolerance) = 0;
  /// Whether sides that are near each other resist their motion in load steps: CONTACT STABILIZATION.
  virtual bool is_stabilized() const = 0;
  /// Has them do so by as much from the next trial on.
  virtual void stabilize(const StabilizationLevel& level) = 0;
  virtual Stabilization stabilization() const = 0;
  /// The size of the forces of that in the last trial [force].
  virtual double stabilizing_force() const = 0;
  /// How far a node may move in one trial without getting past what it should touch [length].
  virtual double longest_motion() const = 0;
  /// Ends a step that found no equilibrium: what is known is that of its start.
  virtual void give_up_trials() = 0;
  /// Ends a step with the state that the last trial was of, which becomes what is remembered.
  virtual ForceReport accept_trial(const Motion& motion, Eigen::Matrix3Xd& forces) = 0;
};

}  // namespace contactsim
