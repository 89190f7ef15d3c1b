// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/face_forces.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace contactsim {

namespace {

/// Signs of the corners' natural coordinates.
constexpr double sign_r[4] = {-1.0, 1.0, 1.0, -1.0}, sign_s[4] = {-1.0, -1.0, 1.0, 1.0};

/// Calls add(shape functions, normal times the area that the point stands for) at each Gauss point; all
/// weights are 1.
template <class Add>
void for_each_point(const Corners& x, const Add& add) {
  const double at = 1.0 / std::sqrt(3.0);
  const Eigen::Vector3d along_r = 0.25 * (x.col(1) - x.col(0) + x.col(2) - x.col(3));
  const Eigen::Vector3d along_s = 0.25 * (x.col(3) - x.col(0) + x.col(2) - x.col(1));
  const Eigen::Vector3d twist = 0.25 * (x.col(0) - x.col(1) + x.col(2) - x.col(3));
  for (int point = 0; point < 4; ++point) {
    const double r = at * sign_r[point], s = at * sign_s[point];
    Eigen::Vector4d shape;
    for (int a = 0; a < 4; ++a) shape(a) = 0.25 * (1.0 + r * sign_r[a]) * (1.0 + s * sign_s[a]);
    const Eigen::Vector3d tangent_r = along_r + s * twist, tangent_s = along_s + r * twist;
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

Corners traction_forces(const Corners& corners, const Eigen::Vector4d& traction,
                        const Eigen::Vector3d& direction) {
  Corners forces = Corners::Zero();
  for_each_point(corners, [&](const Eigen::Vector4d& shape, const Eigen::Vector3d& area) {
    forces += (traction.dot(shape) * area.norm() * direction) * shape.transpose();
  });
  return forces;
}

}  // namespace contactsim
