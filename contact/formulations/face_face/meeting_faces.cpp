// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/meeting_faces.hpp"

#include "contact/geometry/common_plane.hpp"
#include "contact/smoothing/smooth_overlap.hpp"

namespace contactsim {

void carry_along(const PartnerCarry& carry, MovingFace& first, MovingFace& second) {
  if (carry.is_zero()) return;
  MovingFace& still = carry.is_of_first ? first : second;
  still = carry.carried(still);
}

void carry_along(const PartnerCarry& carry, ContactPoint& contact_point) {
  if (!carry.is_zero())
    (carry.is_of_first ? contact_point.first : contact_point.second).weights += carry.weights;
}

void take_off_gap(double offset, const MovingFace& second, MovingFace& first) {
  if (offset == 0.0) return;
  const auto plane = make_common_plane(first.x, first.look(), second.look());
  if (plane) first.x.colwise() -= offset * plane->normal;
}

FaceFaceContact contact_of(const OverlapShare& share, const MovingFace& first, const MovingFace& second) {
  FaceFaceContact contact;
  contact.normal = share.normal;
  contact.weights_1 = share.weights_1;
  contact.weights_2 = share.weights_2;
  contact.area = share.area;
  contact.gap = gap_of(share, first, second);
  return contact;
}

FaceFaceConstraints MeetingFaces::find_constraints(const ConstraintActivation& activation) const {
  if (!are_round()) return find_face_face_constraints(first, second, activation);
  const SmoothPatch patch_1(first, round_first), patch_2(second, round_second);
  return find_smooth_constraints({patch_1, patch_2, offset}, activation);
}

}  // namespace contactsim
