// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/held_directions.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// Projects the vectors of held nodes on their free directions.
///   first  of the nodes' part
void project_nodes(const std::vector<FreeDirections>& free, Eigen::Index first, Eigen::VectorXd& vector) {
  for (const FreeDirections& node : free) {
    auto part = vector.segment<3>(first + 3 * static_cast<Eigen::Index>(node.node.value));
    part = (node.projection * part).eval();
  }
}

/// Leaves nodes no direction, whether or not they have held ones already.
void hold_nodes(const std::vector<NodeIndex>& nodes, std::vector<FreeDirections>& free) {
  const auto by_node = [](const FreeDirections& a, const FreeDirections& b) { return a.node < b.node; };
  std::ranges::sort(free, by_node);
  std::vector<FreeDirections> others;
  for (const NodeIndex node : nodes) {
    const FreeDirections held{node, Eigen::Matrix3d::Zero()};
    const auto known = std::ranges::lower_bound(free, held, by_node);
    if (known != free.end() && known->node == node) {
      *known = held;
    } else {
      others.push_back(held);
    }
  }
  free.insert(free.end(), others.begin(), others.end());
}

}  // namespace

void HeldDirections::find(const Model& model, const StaticBodies& bodies, double time) {
  free_ = model.kinematic_constraints.find_free_directions(time);
  bodies.add_free(free_);
  if (turns_) free_rotations_ = model.rotation_constraints.find_free_directions(time);
  hold_lifeless();
}

void HeldDirections::hold_lifeless() {
  if (lifeless_.empty()) return;
  hold_nodes(lifeless_, free_);
  if (turns_) hold_nodes(lifeless_, free_rotations_);
}

void HeldDirections::project(Eigen::VectorXd& vector) const {
  project_nodes(free_, 0, vector);
  project_nodes(free_rotations_, n_, vector);
}

FreeProjections::FreeProjections(const HeldDirections& held, std::size_t n_nodes) : places_(2 * n_nodes) {
  held.visit([&](std::uint32_t node, Eigen::Index first, const Eigen::Matrix3d& along) {
    places_[2 * std::size_t{node} + (first > 0 ? 1 : 0)] = static_cast<std::uint32_t>(projections_.size());
    projections_.push_back(Eigen::Matrix3d::Identity() - along);
  });
}

}  // namespace contactsim
