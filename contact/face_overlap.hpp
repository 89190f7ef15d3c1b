// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "contact/face_map.hpp"
#include "core/lanes.hpp"

namespace contactsim {

/// Faces whose normals have a greater cosine than this stand beside each other, such as those round a convex
/// corner, and not opposite.
inline constexpr double most_aside = -0.3;

/// Two faces that look at each other, seen along the normal of a plane between them.
struct CommonPlane {
  Eigen::Vector3d normal;         ///< unit, from the second face towards the first [1]
  Eigen::Vector3d across, along;  ///< unit vectors of the plane; across x along = normal [1]
  Eigen::Vector3d origin;         ///< [length]
};

/// The plane between two faces: its normal is the mean of theirs, the second one's turned round, so that
/// swapping the faces only turns it round as well. Nothing when the faces do not look at each other.
///   area_1, area_2  area vectors of the faces, of any length, out of the elements
/// Source: Belytschko and Yeh, Comput. Methods Appl. Mech. Eng. 105 (1993); Tribol's common plane.
std::optional<CommonPlane> make_common_plane(const FaceCorners& first, const Eigen::Vector3d& area_1,
                                             const Eigen::Vector3d& area_2);

/// A face in the coordinates of a common plane: rows across, along, normal [length].
FaceCorners project(const FaceCorners& face, const CommonPlane& plane);

/// Points at which pressure is integrated over the overlap of two faces, and where they lie on both.
struct OverlapPoints {
  static constexpr int max_batches = 2;

  int n_batches = 0;
  double area = 0.0;                      ///< of the overlap, seen along the normal [length^2]
  std::array<Lanes, max_batches> weight;  ///< area that each point stands for, 0 of lanes not used [length^2]
  std::array<Lanes, max_batches> xi_1, eta_1, xi_2, eta_2;  ///< [1]
};

/// Intersects two faces on their common plane and finds the points of a quadrature that is exact for
/// quadratic polynomials. Nothing when they do not overlap.
///   first, second  in the coordinates of the plane
OverlapPoints find_overlap(const FaceCorners& first, const FaceMap& map_1, const FaceCorners& second,
                           const FaceMap& map_2);

}  // namespace contactsim
