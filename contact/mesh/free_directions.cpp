// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/free_directions.hpp"

#include <algorithm>
#include <utility>

#include "core/dynamics/model.hpp"

namespace contactsim {

bool ModelFreeDirections::Directions::update(const KinematicConstraints& kinematic_constraints, double time) {
  std::vector<std::uint8_t> now = kinematic_constraints.find_active(time);
  if (now == active) return false;
  active = std::move(now);
  held = kinematic_constraints.find_free_directions(time);
  return true;
}

const Eigen::Matrix3d* ModelFreeDirections::Directions::find(std::uint32_t node) const {
  const auto found = std::ranges::lower_bound(held, NodeIndex{node}, {}, &FreeDirections::node);
  return found != held.end() && found->node.value == node ? &found->projection : nullptr;
}

bool ModelFreeDirections::update(const Model& model, double time) {
  const bool nodes = nodes_.update(model.kinematic_constraints, time),
             turns = turns_.update(model.rotation_constraints, time),
             bodies = bodies_.update(model.rigid.kinematic_constraints, time),
             body_turns = body_turns_.update(model.rigid.rotation_constraints, time);
  return nodes || turns || bodies || body_turns;
}

}  // namespace contactsim
