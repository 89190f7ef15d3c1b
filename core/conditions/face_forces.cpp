// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/face_forces.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace contactsim {

namespace {

/// Signs of the corners' natural coordinates.
constexpr double sign_r[4] = {-1.0, 1.0, 1.0, -1.0}, sign_s[4] = {-1.0, -1.0, 1.0, 1.0};

/// Derivatives of the position: along r it is along_r + s * twist, along s along_s + r * twist.
struct Tangents {
  explicit Tangents(const Corners& x)
      : along_r(0.25 * (x.col(1) - x.col(0) + x.col(2) - x.col(3))),
        along_s(0.25 * (x.col(3) - x.col(0) + x.col(2) - x.col(1))),
        warp(0.25 * (x.col(0) - x.col(1) + x.col(2) - x.col(3))) {}
  Eigen::Vector3d along_r, along_s, warp;
};

/// Calls add(shape functions, normal times the area that the point stands for) at each Gauss point; all
/// weights are 1.
template <class Add>
void for_each_point(const Corners& x, const Add& add) {
  const double at = 1.0 / std::sqrt(3.0);
  const Tangents tangents(x);
  for (int point = 0; point < 4; ++point) {
    const double r = at * sign_r[point], s = at * sign_s[point];
    Eigen::Vector4d shape;
    for (int a = 0; a < 4; ++a) shape(a) = 0.25 * (1.0 + r * sign_r[a]) * (1.0 + s * sign_s[a]);
    const Eigen::Vector3d tangent_r = tangents.along_r + s * tangents.warp;
    const Eigen::Vector3d tangent_s = tangents.along_s + r * tangents.warp;
    add(shape, Eigen::Vector3d(tangent_r.cross(tangent_s)));
  }
}

}  // namespace

Corners pressure_forces(const Corners& corners, const Eigen::Vector4d& pressure) {
  Corners forces = Corners::Zero();
  for_each_point(corners, [&](const Eigen::Vector4d& shape, const Eigen::Vector3d& area) {
    forces -= (pressure.dot(shape) * area) * shape.transpose();
  });
  return forces;
}

/// The normal is linear in r and s, so that only the constant part of a shape function and the part along the
/// same coordinate, a third of its sign, are left of the integral.
Corners pressure_forces(const Corners& corners, double pressure) {
  const Tangents tangents(corners);
  const Eigen::Vector3d middle = -pressure * tangents.along_r.cross(tangents.along_s);
  const Eigen::Vector3d along_r = -pressure / 3.0 * tangents.along_r.cross(tangents.warp);
  const Eigen::Vector3d along_s = -pressure / 3.0 * tangents.warp.cross(tangents.along_s);
  Corners forces;
  for (int a = 0; a < 4; ++a) forces.col(a) = middle + sign_r[a] * along_r + sign_s[a] * along_s;
  return forces;
}

Corners traction_forces(const Corners& corners, const Eigen::Vector4d& traction,
                        const Eigen::Vector3d& direction) {
  Corners forces = Corners::Zero();
  for_each_point(corners, [&](const Eigen::Vector4d& shape, const Eigen::Vector3d& area) {
    forces += (traction.dot(shape) * area.norm() * direction) * shape.transpose();
  });
  return forces;
}

}  // namespace contactsim
