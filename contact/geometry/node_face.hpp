// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "contact/geometry/face_map.hpp"
#include "core/base/lanes.hpp"
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

/// Points, each with a face that it is to be projected onto, one pair a lane.
class ProjectionLanes {
 public:
  std::size_t size() const { return n_; }
  bool are_full() const { return n_ == n_lanes; }
  void clear() { n_ = 0; }
  /// Precondition: they are not full.
  ///   x  corners [length]
  void add(const FaceCorners& x, bool is_triangle, const Eigen::Vector3d& point);

  /// Projects every point onto its face along the face's normal: Newton's method on the distance. The closest
  /// point stays where it is when it lies beyond an edge, so that forces along the normal, shared among the
  /// corners by its coordinates, have no moment. Nothing where there is no projection. Each lane has what it
  /// would have alone; those that are not filled mean nothing. Precondition: one is filled.
  /// Source: Hallquist, Goudreau and Benson, Comput. Methods Appl. Mech. Eng. 51 (1985) 107-137, eq. 12.
  std::array<std::optional<ClosestPoint>, n_lanes> project() const;

 private:
  CornersOfFaces corners_;  // lanes that are not filled have what the first one has
  DoubleVectors points_;
  unsigned triangles_ = 0;  // as bits
  std::size_t n_ = 0;
};

/// Projects one point onto a face. Nothing when there is no projection.
///   x  corners [length]
std::optional<ClosestPoint> project_onto_face(const FaceCorners& x, bool is_triangle,
                                              const Eigen::Vector3d& point);

/// The same of a sphere around a point: gap and normal are those of the nearest point of the face, which may
/// be on an edge. Nothing when the point is behind a face that it is not over. Without a radius it is the
/// point.
///   radius  >= 0 [length]
std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle,
                                           const Eigen::Vector3d& centre, double radius);
/// The same where the projection of the point is known.
std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle,
                                           const Eigen::Vector3d& centre, double radius,
                                           const std::optional<ClosestPoint>& flat);

/// Moves coordinates into the face; returns the edge that they were furthest beyond, if any.
OptionalIndex<std::uint32_t> move_inside(bool is_triangle, double& xi, double& eta);

}  // namespace contactsim
