// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/constraint_system.hpp"
#include "contact/enforcement/contact_history.hpp"
#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// Lost in half of the step before and in half of the coming one, to friction and by impact [energy].
struct ContactLoss {
  double friction_before = 0.0, friction_after = 0.0, impact_before = 0.0, impact_after = 0.0;

  ContactLoss& operator+=(const ContactLoss& other) {
    friction_before += other.friction_before;
    friction_after += other.friction_after;
    impact_before += other.impact_before;
    impact_after += other.impact_after;
    return *this;
  }
};

/// The energy that the forces of a step take from the bodies, point by point: force times relative motion,
/// over half of the step before and half of the coming one. To be used while system and motion stay.
struct ConstraintLosses {
  ConstraintSystem& system;
  const ContactKinematics& kinematics;
  double dt_before, dt;  ///< of the step that ended, of the coming one [time]
  /// Nothing has acted before the step: the half step before it mirrors the first one.
  bool is_first_step;

  /// Gives the point of a row its force, friction, slip and losses, and adds these to the sums. Returns what
  /// the next step is to know of it.
  ///   force   along the normal [force]
  ///   change  by which all forces change gap and slip in the coming step [length]
  ContactHistory::Entry finish(const ConstraintRow& row, double force, const NodeVector& change,
                               ContactLoss& loss) const;
  /// The same of a row that presses along its normal alone.
  ///   opened_before  by which its gap opened in the step before [length]
  ///   opened         by which all forces open it in the coming step [length]
  ContactHistory::Entry finish_pressing(const ConstraintRow& row, double force, double opened_before,
                                        double opened, ContactLoss& loss) const;

 private:
  ContactHistory::Entry finish_normal(const ConstraintRow& row, double force, double impact_before,
                                      double opened, ContactLoss& loss) const;
  double lost_before(const Eigen::Vector3d& force, const ContactPoint& point, const Eigen::Vector3d& before,
                     const Eigen::Vector3d& changed) const;
  void finish_friction(const ConstraintRow& row, double force, const NodeVector& change,
                       const Eigen::Vector3d& before, ContactHistory::Entry& entry, ContactLoss& loss) const;
};

}  // namespace contactsim
