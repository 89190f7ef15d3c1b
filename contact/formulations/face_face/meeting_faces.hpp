// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/start_partners.hpp"
#include "contact/geometry/contact_point.hpp"
#include "contact/geometry/face_face_constraints.hpp"
#include "contact/smoothing/smooth_face.hpp"

namespace contactsim {

/// Two faces in the positions in which their gap is measured: one of them carried along with the other where
/// they slide infinitesimally, flat ones moved by the offset of the gap. The gap of round surfaces that they
/// stand for is still to lose the offset.
struct MeetingFaces {
  MovingFace first, second;
  const SmoothFace *round_first, *round_second;  ///< null of a face that stands for itself
  double offset;                                 ///< taken off the gap [length]
  bool did_touch;                                ///< in the last step

  bool are_round() const { return round_first != nullptr || round_second != nullptr; }
  /// The contact points of the faces, or of their round surfaces, as constraints.
  FaceFaceConstraints find_constraints(const ConstraintActivation& activation) const;
};

/// Carries the still one of two faces along with the other; the weights of a contact point follow.
void carry_along(const PartnerCarry& carry, MovingFace& first, MovingFace& second);
void carry_along(const PartnerCarry& carry, ContactPoint& contact_point);

/// Takes an offset off the gap of two faces: the first one moves against their common normal, which stays.
/// Nothing happens to faces that do not face each other.
void take_off_gap(double offset, const MovingFace& second, MovingFace& first);

/// A part of the overlap of two faces as a contact of both, by its mean gap; it has no force.
FaceFaceContact contact_of(const OverlapShare& share, const MovingFace& first, const MovingFace& second);

}  // namespace contactsim
