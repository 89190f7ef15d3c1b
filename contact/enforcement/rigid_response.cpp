// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/rigid_response.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace contactsim {

void RigidResponse::begin(const RigidMatrix& mobility) {
  mobility_ = mobility;
  impulse_.setZero();
  velocity_.setZero();
  answer_.setZero();
  slope_.setZero();
  size_ = 0.0;
}

void RigidResponse::add(const RigidLever& lever, const Eigen::Vector3d& change, const Eigen::Matrix3d& rate) {
  const RigidVector on_body = lever.transpose() * change;
  answer_ += on_body;
  size_ += on_body.norm();
  slope_ += lever.transpose() * rate * lever;
}

bool RigidResponse::step() {
  constexpr double round_off = 1e-12;
  const RigidVector missing = answer_ - impulse_;
  const bool stays = missing.norm() <= round_off * size_;
  if (!stays) {
    const RigidMatrix jacobian = RigidMatrix::Identity() + slope_ * mobility_;
    impulse_ += jacobian.partialPivLu().solve(missing);
    velocity_ = mobility_ * impulse_;
  }
  answer_.setZero();
  slope_.setZero();
  size_ = 0.0;
  return stays;
}

std::uint32_t RigidResponses::of(std::uint32_t carrier) {
  const auto known = std::ranges::find(bodies_, carrier, &Body::carrier);
  const auto index = static_cast<std::uint32_t>(known - bodies_.begin());
  if (known == bodies_.end()) bodies_.push_back({carrier, {}});
  return index;
}

}  // namespace contactsim
