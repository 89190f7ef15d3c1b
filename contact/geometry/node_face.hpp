// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "contact/geometry/face_map.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// Where a point projects inside a face, or over the face carried on beyond its edges.
struct ClosestPoint {
  double xi = 0.0, eta = 0.0;                        ///< of the closest point [1]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the face there: unit, out of the element [1]
  double gap = 0.0;                                  ///< along the normal, < 0 behind the face [length]
  double beyond =
      0.0;  ///< distance by which the point lies beyond the face's edges; 0 over the face [length]
  /// The edge that it lies beyond, from the corner of that number to the next; absent over the face.
  OptionalIndex<std::uint32_t> edge;
};

/// Projects a point onto a face along the face's normal: Newton's method on the distance. The closest point
/// stays where it is when it lies beyond an edge, so that forces along the normal, shared among the corners
/// by its coordinates, have no moment. Nothing when there is no projection.
///   x  corners [length]
/// Source: Hallquist, Goudreau and Benson, Comput. Methods Appl. Mech. Eng. 51 (1985) 107-137, eq. 12.
std::optional<ClosestPoint> project_onto_face(const FaceCorners& x, bool is_triangle,
                                              const Eigen::Vector3d& point);

/// The same of a sphere around a point: gap and normal are those of the nearest point of the face, which may
/// be on an edge. Nothing when the point is behind a face that it is not over. Without a radius it is the
/// point.
///   radius  >= 0 [length]
std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle,
                                           const Eigen::Vector3d& centre, double radius);

/// Moves coordinates into the face; returns the edge that they were furthest beyond, if any.
OptionalIndex<std::uint32_t> move_inside(bool is_triangle, double& xi, double& eta);

}  // namespace contactsim
