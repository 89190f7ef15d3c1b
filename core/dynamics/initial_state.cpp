// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/initial_state.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/memory_pages.hpp"
#include "core/conditions/initial_velocity.hpp"
#include "core/definition/region.hpp"
#include "core/dynamics/initial_condition.hpp"
#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

/// Place of a number among those of an integration point; nothing when the material does not have it.
std::optional<std::size_t> find_place(const ModelBlock& block, const InitialElementValues& given) {
  constexpr std::size_t n_stresses = 6;
  if (given.variable == "stress") return given.component;
  for (const StateVariable& variable : block.properties.law.kind().variables) {
    if (variable.name == given.variable) return n_stresses + variable.first + given.component;
  }
  return std::nullopt;
}

/// The lanes that fill up the last batch follow the last element.
void set_block(const InitialElementValues& given, const ModelBlock& block, ModelBlockState& state) {
  const auto place = find_place(block, given);
  if (!place) return;
  for (std::size_t i = 0; i < block.n_batches() * n_lanes; ++i) {
    const std::size_t element = block.first_element.value + std::min(i, block.n_elements - 1);
    const double value = given.values[element];
    if (std::isnan(value)) continue;
    const auto batch = state.batch(block.layout, i / n_lanes);
    for (std::size_t point = 0; point < block.layout.n_points; ++point)
      batch[point * block.layout.point_size + *place](static_cast<Eigen::Index>(i % n_lanes)) = value;
  }
}

}  // namespace

InitialState make_initial_state(const ConditionScope& scope, std::span<const ModelBlock> blocks) {
  InitialState state;
  resize_in_huge_pages(scope.mesh.n_nodes(), state.velocity);
  state.velocity.setZero();
  const bool turns =
      std::ranges::any_of(blocks, [](const ModelBlock& block) { return block.element->has_rotations; });
  if (turns) state.angular_velocity = state.velocity;
  set_initial_velocity(scope, state.velocity, turns ? &state.angular_velocity : nullptr);
  InitialConditionSetter setter(scope, blocks, state);
  for (const InitialCondition& condition : scope.region.initial_conditions) setter.set(condition);
  return state;
}

void set_initial_state(InitialState initial, std::span<const ModelBlock> blocks, State& state) {
  if (initial.velocity.cols() > 0) state.velocity = std::move(initial.velocity);
  if (initial.displacement.cols() > 0) state.coordinates += initial.displacement;
  if (state.rotations.exist()) state.rotations.velocity = std::move(initial.angular_velocity);
  for (const InitialElementValues& given : initial.element_values) {
    for (std::size_t i = 0; i < blocks.size(); ++i) set_block(given, blocks[i], state.blocks[i]);
  }
}

}  // namespace contactsim
