// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/point_in_solid.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace contactsim {

namespace {

/// Share of a tetrahedron's volume by which a point may lie outside through round-off.
constexpr double round_off = 1e-9;

double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.cross(b).dot(c);
}

/// Whether the tetrahedron of the point `origin` and three others holds a point, whichever way it is turned.
bool is_in_tetrahedron(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& origin,
                       const Eigen::Vector3d& point) {
  const Eigen::Vector3d a = corners[0] - origin, b = corners[1] - origin, c = corners[2] - origin;
  const Eigen::Vector3d p = point - origin;
  const double whole = volume(a, b, c);
  const double cube = a.norm() * b.norm() * c.norm();
  if (!(std::abs(whole) > round_off * cube)) return false;
  const double u = volume(p, b, c) / whole, v = volume(a, p, c) / whole, w = volume(a, b, p) / whole;
  return u >= -round_off && v >= -round_off && w >= -round_off && u + v + w <= 1.0 + round_off;
}

}  // namespace

bool is_in_solid(const Eigen::Ref<const Eigen::Matrix3Xd>& corners, const Topology& shape,
                 const Eigen::Vector3d& point) {
  const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
    return corners.col(static_cast<Eigen::Index>(k));
  };
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < shape.n_corners; ++k) middle += corner(k);
  middle /= shape.n_corners;
  for (const Side& side : shape.sides) {
    if (side.kind != SideKind::face) continue;
    Eigen::Vector3d of_face = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < side.n_corners; ++k) of_face += corner(side.corners[k]);
    of_face /= side.n_corners;
    for (std::size_t k = 0; k < side.n_corners; ++k) {
      const std::size_t next = (k + 1) % side.n_corners;
      const std::array triangle{corner(side.corners[k]), corner(side.corners[next]), of_face};
      if (is_in_tetrahedron(triangle, middle, point)) return true;
    }
  }
  return false;
}

}  // namespace contactsim
