// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/statics/nonlinear_cg.hpp"

namespace contactsim {

/// Finds the stiffness at an increment anew.
///   may_keep_elements  contact alone; else that of the mesh, too
using Renew = std::function<void(const Eigen::VectorXd& increment, bool may_keep_elements)>;

/// The linear equations of Newton's steps: minimal residuals in which the product of stiffness and direction
/// is a difference of two residuals. Near balance that is all there is: friction that slides, normals that
/// turn, faces that slide on, materials that harden. Farther off contact resists by its springs, without what
/// its large forces soften. The preconditioner follows the stiffness when it makes too many iterations.
/// Source: Knoll and Keyes, J. Comput. Phys. 193 (2004) 357-397; inexact steps: Dembo, Eisenstat and
/// Steihaug, SIAM J. Numer. Anal. 19 (1982) 400-408.
class LinearisedEquilibrium {
 public:
  /// All must outlive it.
  LinearisedEquilibrium(Equilibrium& equilibrium, Preconditioner& preconditioner, Renew renew)
      : equilibrium_(equilibrium), preconditioner_(preconditioner), renew_(std::move(renew)) {}

  /// Sets z to what brings a right side to balance on the equilibrium linearised at an increment.
  ///   residual  at the increment
  ///   report    which counts are added to
  void solve(const Eigen::VectorXd& increment, const Eigen::VectorXd& residual, const Eigen::VectorXd& right,
             CgReport& report, Eigen::VectorXd& z);
  /// Begins a load step, for which the preconditioner is new: a restart then goes the same way.
  void begin_step() { most_left_behind_ = least_left_behind; }
  /// Takes notice that contact may have closed, opened, begun to stick or to slide.
  void note_contact(const Eigen::VectorXd& increment) { renew_(increment, true); }
  /// Has friction slide at the limits of the last evaluation until they are let follow what presses; not
  /// where contact alone holds a body, which may slide away. Returns whether any are held.
  bool hold_slip_limits() { return holds_slip_limits_ = !has_free_ && equilibrium_.hold_slip_limits(true); }
  void free_slip_limits() { holds_slip_limits_ = equilibrium_.hold_slip_limits(false); }
  /// Takes notice whether contact alone holds a body.
  void set_free(bool has_free) { has_free_ = has_free; }
  bool holds_slip_limits() const { return holds_slip_limits_; }
  /// Whether contact is linearised by differences, too.
  void set_near(bool is_near) { is_near_ = is_near; }

 private:
  Equilibrium& equilibrium_;
  Preconditioner& preconditioner_;
  Renew renew_;
  bool is_near_ = false;
  static constexpr int least_left_behind = 20;
  int most_left_behind_ = least_left_behind;  // iterations by a preconditioner that is not that of now
  bool holds_slip_limits_ = false, has_free_ = false;
};

/// Searches by Newton's steps: for bodies that bend far, whose residual grows before it falls, so that a
/// search along lines creeps, and for contact. Gives up where it has got no smaller for some steps. Source:
/// Bathe, Finite Element Procedures (1996), 8.4.1.
CgReport newton(Equilibrium& equilibrium, LinearisedEquilibrium& linearised, const CgSettings& settings,
                Eigen::VectorXd& increment);

/// Improves an increment by what brings it to balance on the equilibrium linearised there: predict_linearly()
/// with one step of Newton's.
/// Returns the number of evaluations of the residual.
std::int64_t predict_by_newton(Equilibrium& equilibrium, LinearisedEquilibrium& linearised,
                               const Eigen::VectorXd& prescribed, Eigen::VectorXd& increment);

}  // namespace contactsim
