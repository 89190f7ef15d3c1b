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

void MovingSurface::update(const Motion& motion) {
  const auto n_nodes = static_cast<std::int64_t>(faces_.n_nodes());
  x_.resize(faces_.n_nodes());
  v_.resize(faces_.n_nodes());
  bounds_.resize(faces_.faces.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(faces_.n_nodes()))
  for (std::int64_t i = 0; i < n_nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    x_[k].head<3>() = motion.coordinates.col(faces_.mesh_nodes[k]);
    v_[k].head<3>() = motion.velocity.col(faces_.mesh_nodes[k]);
    x_[k][3] = v_[k][3] = 0.0;
  }
  const auto n_faces = static_cast<std::int64_t>(faces_.faces.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(faces_.faces.size()))
  for (std::int64_t i = 0; i < n_faces; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const ContactFace& face = faces_.faces[k];
    const FaceCorners x = gather_corners(face.corners, x_);
    FaceBound& bound = bounds_[k];
    bound.centre = mean(x, face.is_triangle());
    bound.velocity = mean(gather_corners(face.corners, v_), face.is_triangle());
    bound.normal = area_vector(x).normalized();
    bound.radius = std::sqrt((x.colwise() - bound.centre).colwise().squaredNorm().maxCoeff());
  }
}

MovingFace MovingSurface::face(std::uint32_t index) const {
  const ContactFace& face = faces_.faces[index];
  return {gather_corners(face.corners, x_), gather_corners(face.corners, v_), bounds_[index].normal,
          face.is_triangle()};
}

}  // namespace contactsim
