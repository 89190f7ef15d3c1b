// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "contact/geometry/face_face_constraints.hpp"
#include "contact/smoothing/smooth_face.hpp"

/// Two faces of which one or both stand for round surfaces. They are seen along the normal of the plane
/// between the faces, whose corners lie on the surfaces; a point of that plane is found on each surface, not
/// on the face below. Gaps, areas and normals are those of the surfaces; forces act on the faces.
namespace contactsim {

/// Both surfaces of two faces, as they are.
struct SmoothSides {
  const SmoothPatch &first, &second;
  double offset = 0.0;  ///< taken off the gap [length]
};

/// find_face_face_contact() of the surfaces. The normal is the mean of theirs by force, and the corners'
/// weights have both points of attack on the line through the centre of force along it, so that neither force
/// nor moment is left.
FaceFaceContact find_smooth_contact(const SmoothSides& sides, const PairPenalty& penalty,
                                    double activation_distance);

/// find_face_face_constraints() of the surfaces.
FaceFaceConstraints find_smooth_constraints(const SmoothSides& sides, const ConstraintActivation& activation);

/// find_corner_shares() of the surfaces; the normal of each share is the mean of theirs.
CornerShares find_smooth_corner_shares(const SmoothSides& sides, bool is_of_first);

/// Changes weights of the corners of two faces by as little as brings their points onto the line along the
/// normal through a place, so that forces there leave no moment.
void bring_onto_line(const MovingFace& first, const MovingFace& second, const Eigen::Vector3d& place,
                     FaceFaceContact& contact);

/// The gap of the surfaces over all of the overlap of two faces.
struct SmoothGap {
  double mean = 0.0, smallest = 0.0;  ///< [length]
  double area = 0.0;                  ///< [length^2]
};

/// Nothing when the faces do not face each other or do not overlap.
std::optional<SmoothGap> find_smooth_gap(const SmoothSides& sides);

}  // namespace contactsim
