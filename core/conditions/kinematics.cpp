// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/kinematics.hpp"

#include <cstdint>
#include <utility>

namespace contactsim {

namespace {

std::vector<NodeIndex> all_nodes(const Mesh& mesh, std::span<const DrivenNodes> driven) {
  std::vector<std::uint8_t> is_driven(mesh.n_nodes(), 0);
  for (const DrivenNodes& one : driven) {
    for (const NodeIndex node : one.nodes) is_driven[node.value] = 1;
  }
  std::vector<NodeIndex> nodes;
  for (std::uint32_t i = 0; i < is_driven.size(); ++i) {
    if (is_driven[i] != 0) nodes.push_back({i});
  }
  return nodes;
}

}  // namespace

Kinematics::Kinematics(const Mesh& mesh, std::vector<DrivenNodes> driven)
    : mesh_(&mesh), driven_(std::move(driven)), nodes_(all_nodes(mesh, driven_)) {}

void Kinematics::constrain(const BetweenSteps& now, Eigen::Matrix3Xd& acceleration) const {
  for (const DrivenNodes& driven : driven_) {
    if (driven.times.is_active(now.time)) driven.set_acceleration(now, *mesh_, acceleration);
  }
}

void Kinematics::constrain_velocity(const BetweenSteps& start, Eigen::Matrix3Xd& velocity) const {
  for (const DrivenNodes& driven : driven_) {
    if (driven.times.is_active(start.time)) driven.set_velocity(start, *mesh_, velocity);
  }
}

}  // namespace contactsim
