// SPDX-License-Identifier: BSD-3-Clause
#include "contact/moving_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/threads.hpp"

namespace contactsim {

namespace {

FaceCorners gather_corners(const std::array<std::uint32_t, 4>& corners,
                           const std::vector<NodeVector>& values) {
  FaceCorners gathered;
  for (int k = 0; k < 4; ++k) gathered.col(k) = values[corners[static_cast<std::size_t>(k)]].head<3>();
  return gathered;
}

/// Mean of the corners, each of a triangle's once.
Eigen::Vector3d mean(const FaceCorners& x, bool is_triangle) {
  if (is_triangle) return (x.col(0) + x.col(1) + x.col(2)) / 3.0;
  return 0.25 * (x.col(0) + x.col(1) + x.col(2) + x.col(3));
}

}  // namespace

bool may_touch(const FaceBound& a, const FaceBound& b, double reach) {
  if (a.normal.dot(b.normal) > most_aside) return false;
  const Eigen::Vector3d apart = a.centre - b.centre, tilt = a.normal + b.normal;
  const double height = apart.dot(b.normal);
  if (height > reach + a.extent(b.normal) + b.twist) return false;
  // Seen along the common normal instead of the second face's, places move by this much.
  const double slack = tilt.norm() * (std::abs(height) + 0.25 * (a.radius + b.radius));
  for (const Eigen::Vector3d& direction : {b.half_1, b.half_2, a.half_1, a.half_2}) {
    const double room = a.extent(direction) + b.extent(direction) + slack * direction.norm();
    if (std::abs(apart.dot(direction)) > room) return false;
  }
  return true;
}

bool may_stand_over(const Eigen::Vector3d& point, const FaceBound& face, double reach, double depth,
                    double beyond) {
  const Eigen::Vector3d away = point - face.centre;
  const double height = away.dot(face.normal);
  if (height > reach + face.twist || height < -depth - face.twist) return false;
  // The foot of a point off a warped face lies aside by as much as its normal turns.
  const double turned = face.twist / face.radius, slack = beyond + 2.0 * turned * std::abs(height);
  for (const Eigen::Vector3d& direction : {face.half_1, face.half_2}) {
    if (std::abs(away.dot(direction)) > face.extent(direction) + slack * direction.norm()) return false;
  }
  return true;
}

void MovingSurface::move_nodes(const Motion& motion) {
  const auto n_nodes = static_cast<std::int64_t>(faces_.n_nodes());
  x_.resize(faces_.n_nodes());
  v_.resize(faces_.n_nodes());
#pragma omp parallel for schedule(static) num_threads(threads_for(faces_.n_nodes()))
  for (std::int64_t i = 0; i < n_nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    x_[k] << motion.coordinates.col(faces_.mesh_nodes[k]), 0.0;
    v_[k] << motion.velocity.col(faces_.mesh_nodes[k]), 0.0;
  }
}

void MovingSurface::bound_all() {
  bounds_.resize(faces_.faces.size());
  const auto n = static_cast<std::int64_t>(bounds_.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(bounds_.size()))
  for (std::int64_t i = 0; i < n; ++i) set_bound(static_cast<std::size_t>(i));
}

void MovingSurface::bound_watched() {
  const auto n = static_cast<std::int64_t>(watched_.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(watched_.size()))
  for (std::int64_t i = 0; i < n; ++i) set_bound(watched_[static_cast<std::size_t>(i)]);
}

void MovingSurface::set_bound(std::size_t index) {
  const ContactFace& face = faces_.faces[index];
  const FaceCorners x = gather_corners(face.corners, x_);
  FaceBound& bound = bounds_[index];
  bound.centre = mean(x, face.is_triangle());
  bound.velocity = mean(gather_corners(face.corners, v_), face.is_triangle());
  bound.normal = area_vector(x).normalized();
  bound.radius = std::sqrt((x.colwise() - bound.centre).colwise().squaredNorm().maxCoeff());
  const FaceMap map = make_face_map(x, face.is_triangle());
  const double half = face.is_triangle() ? 0.5 : 1.0;
  bound.half_1 = half * map.c[1];
  bound.half_2 = half * map.c[2];
  // The parallelogram of a triangle has its middle elsewhere.
  bound.twist = face.is_triangle() ? (map.c[1] + map.c[2]).norm() / 6.0 : map.c[3].norm();
}

MovingFace MovingSurface::face(std::uint32_t index) const {
  const ContactFace& face = faces_.faces[index];
  return {gather_corners(face.corners, x_), gather_corners(face.corners, v_), bounds_[index].normal,
          face.is_triangle()};
}

Eigen::Vector3d MovingSurface::corner_area(std::uint32_t index) const {
  const ContactFace& face = faces_.faces[index];
  return area_vector(gather_corners(face.corners, x_)) / (face.is_triangle() ? 3.0 : 4.0);
}

double MovingSurface::area_against(const SurfaceNode& node, const Eigen::Vector3d& normal) const {
  constexpr double least_share = 0.01;
  double area = 0.0;
  bool has_faces = false;
  for (const std::uint32_t face : faces_.faces_of_node.of(node.node)) {
    if (faces_.faces[face].surface != node.surface) continue;
    area += std::max(0.0, -corner_area(face).dot(normal));
    has_faces = true;
  }
  return has_faces ? std::max(area, least_share * node.area) : node.area;
}

}  // namespace contactsim
