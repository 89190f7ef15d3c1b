// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/constraint_system.hpp"
#include "contact/enforcement/light_carriers.hpp"

namespace contactsim {

/// The next force of a constraint in a pass: a step down the gradient of the gap, projected onto what a
/// contact can bear. With the force y that the pass starts from, softness c, start s, compliance e and the
/// change d of the gap by the forces of the pass before:
///   normal      f = max(0, y - (1 - e) / c (s + d + e c y)), without the max where sides may not part
///   tangential  likewise by the slip, cut to the slip limit
/// Refers to the system; to be used while that stays as it is.
class ForceProjection {
 public:
  ///   dt  of the coming step [time]
  ForceProjection(const ConstraintSystem& system, double dt) : system_(system), dt_(dt) {}

  /// The next force of a row on its first side [force].
  ///   normal   of its group
  ///   changed  by which the forces of the last pass change gap and slip [length]
  NodeVector next_force(const NodeVector& normal, const ConstraintRow& row, const NodeVector& changed) const;
  /// The next force and its derivative by the velocity of the point.
  LightAnswer answer(const NodeVector& normal, const ConstraintRow& row, const NodeVector& changed) const;
  /// The largest tangential force of a row with friction [force].
  ///   normal_force  < 0 where it pulls, which holds nothing along the surface [force]
  double slip_limit(const ConstraintRow& row, const NodeVector& changed, double normal_force) const;

 private:
  double normal_force(const NodeVector& normal, const ConstraintRow& row, const NodeVector& changed) const;
  Eigen::Vector3d trial_traction(const Eigen::Vector3d& normal, const ConstraintRow& row,
                                 const NodeVector& changed) const;

  const ConstraintSystem& system_;
  double dt_;
};

}  // namespace contactsim
