// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/relative_velocity.hpp"

namespace contactsim {

Eigen::Vector3d relative_velocity(const ContactKinematics& kinematics, const ContactPoint& point,
                                  bool is_before) {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  const auto add_side = [&](const ContactPointSide& side, double sign) {
    const Eigen::Vector3d beside = -sign * side.radius * point.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = sign * side.weights[static_cast<Eigen::Index>(k)];
      if (weight == 0.0) continue;
      velocity += weight * (is_before ? kinematics.last_velocity_beside(side.nodes[k], beside)
                                      : kinematics.velocity_beside(side.nodes[k], beside));
    }
  };
  add_side(point.first, 1.0);
  add_side(point.second, -1.0);
  return velocity;
}

}  // namespace contactsim
