// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/kinematics.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
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

std::vector<NodeIndex> Kinematics::never_free() const {
  std::vector<std::uint8_t> axes(mesh_ != nullptr ? mesh_->n_nodes() : 0, 0);
  for (const DrivenNodes& driven : driven_) {
    const auto* components = std::get_if<Components>(&driven.direction);
    if (components == nullptr || !(driven.times == ActiveTimes{})) continue;
    std::uint8_t set = 0;
    for (unsigned i = 0; i < 3; ++i)
      set = static_cast<std::uint8_t>(set | (components->is_set[i] ? 1U << i : 0U));
    for (const NodeIndex node : driven.nodes)
      axes[node.value] = static_cast<std::uint8_t>(axes[node.value] | set);
  }
  std::vector<NodeIndex> nodes;
  std::copy_if(nodes_.begin(), nodes_.end(), std::back_inserter(nodes),
               [&](NodeIndex node) { return axes[node.value] == 7; });
  return nodes;
}

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
