// SPDX-License-Identifier: BSD-3-Clause
#include "core/state.hpp"

#include <algorithm>

#include "core/elements/element_table.hpp"

namespace contactsim {

State make_state(const Eigen::Matrix3Xd& coordinates, std::span<const SolidBlock> blocks, double time) {
  State state;
  state.time = time;
  state.coordinates = coordinates;
  const Eigen::Matrix3Xd zero = Eigen::Matrix3Xd::Zero(3, coordinates.cols());
  state.velocity = state.acceleration = zero;
  state.forces = {zero, zero, Eigen::Matrix3Xd(3, 0)};
  const auto turns = [](const SolidBlock& block) { return block.element->has_rotations; };
  const bool any_turns = std::any_of(blocks.begin(), blocks.end(), turns);
  const Eigen::Matrix3Xd none = any_turns ? zero : Eigen::Matrix3Xd(3, 0);
  state.rotations = {none, none, none, {none, none, Eigen::Matrix3Xd(3, 0)}};
  for (const SolidBlock& block : blocks) state.blocks.push_back(make_state(block));
  return state;
}

}  // namespace contactsim
