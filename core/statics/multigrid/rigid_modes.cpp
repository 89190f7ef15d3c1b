// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/rigid_modes.hpp"

#include <Eigen/Geometry>

namespace contactsim {

Modes make_rigid_modes(const Eigen::Matrix3Xd& coordinates) {
  const Eigen::Matrix3Xd arms = coordinates.colwise() - coordinates.rowwise().mean();
  const double farthest = arms.colwise().norm().maxCoeff();
  const double scale = farthest > 0.0 ? 1.0 / farthest : 1.0;
  Modes modes(3 * arms.cols(), 6);
  for (Eigen::Index node = 0; node < arms.cols(); ++node) {
    const Eigen::Vector3d arm = scale * arms.col(node);
    modes.block<3, 3>(3 * node, 0).setIdentity();
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      modes.block<3, 1>(3 * node, 3 + axis) = Eigen::Vector3d::Unit(axis).cross(arm);
  }
  return modes;
}

}  // namespace contactsim
