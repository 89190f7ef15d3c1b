// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/initial_velocity.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/optional_index.hpp"
#include "core/conditions/condition_function.hpp"
#include "core/conditions/direction.hpp"
#include "core/conditions/entity_nodes.hpp"
#include "core/definition/condition_initial.hpp"
#include "core/definition/region.hpp"

namespace contactsim {

namespace {

/// The velocity that one block gives a node; only some components may be meant.
struct GivenVelocity {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  std::array<bool, 3> is_set{true, true, true};
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();  ///< angular velocity, set with all components
};

GivenVelocity along(const Direction& direction, double value, const Eigen::Vector3d& position) {
  if (const auto* components = std::get_if<Components>(&direction))
    return {Eigen::Vector3d::Constant(value), components->is_set};
  if (const auto* unit = std::get_if<Eigen::Vector3d>(&direction)) return {value * *unit};
  const Axis& axis = std::get<Axis>(direction);
  return {value * axis.direction.cross(axis.offset_of(position)), {true, true, true}, value * axis.direction};
}

/// Carries blocks out, one after another.
class VelocitySetter {
 public:
  VelocitySetter(const ConditionScope& scope, Eigen::Matrix3Xd& velocity, Eigen::Matrix3Xd* angular_velocity)
      : scope_(scope),
        velocity_(velocity),
        angular_velocity_(angular_velocity),
        given_by_(3 * scope.mesh.n_nodes()) {}

  void set(std::uint32_t block);

 private:
  /// Nodes whose velocity one block takes over from another.
  struct Overruled {
    std::size_t n_nodes = 0;
    NodeIndex first_node;
    OptionalIndex<std::uint32_t> first_block;
  };

  std::optional<ConditionFunction> find_value(const InitialVelocity& block,
                                              const ConditionLabel& label) const;
  bool set_node(std::uint32_t block, NodeIndex node, const GivenVelocity& given);
  void warn(const ConditionLabel& label, const Overruled& overruled) const;

  const ConditionScope& scope_;
  Eigen::Matrix3Xd& velocity_;
  Eigen::Matrix3Xd* angular_velocity_;  ///< null: nodes do not turn
  std::vector<OptionalIndex<std::uint32_t>>
      given_by_;         ///< [n_nodes x 3] position of the last block that set it
  Overruled overruled_;  ///< by the block that is carried out
};

std::optional<ConditionFunction> VelocitySetter::find_value(const InitialVelocity& block,
                                                            const ConditionLabel& label) const {
  if (block.magnitude) return ConditionFunction(*block.magnitude, label);
  if (block.angular_velocity) return ConditionFunction(*block.angular_velocity, label);
  return make_condition_function(block.function, label, scope_);
}

/// Notes a block whose value is changed.
bool VelocitySetter::set_node(std::uint32_t block, NodeIndex node, const GivenVelocity& given) {
  const bool is_whole = given.is_set[0] && given.is_set[1] && given.is_set[2];
  if (angular_velocity_ != nullptr && is_whole) angular_velocity_->col(node.value) = given.turning;
  OptionalIndex<std::uint32_t> changed;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!given.is_set[c]) continue;
    double& value = velocity_(static_cast<Eigen::Index>(c), node.value);
    OptionalIndex<std::uint32_t>& giver = given_by_[3 * node.value + c];
    if (giver && value != given.velocity(static_cast<Eigen::Index>(c))) changed = giver;
    value = given.velocity(static_cast<Eigen::Index>(c));
    giver = block;
  }
  if (!changed) return given.velocity.allFinite();
  if (overruled_.n_nodes++ == 0) {
    overruled_.first_node = node;
    overruled_.first_block = changed;
  }
  return given.velocity.allFinite();
}

void VelocitySetter::warn(const ConditionLabel& label, const Overruled& overruled) const {
  if (overruled.n_nodes == 0) return;
  const ConditionLabel other{label.what,
                             scope_.region.initial_velocities[*overruled.first_block].name.location};
  const std::string more =
      overruled.n_nodes > 1 ? fmt::format(" and {} more", overruled.n_nodes - 1) : std::string();
  scope_.diagnostics.add_warning(
      "initial-velocity-replaced", label.location,
      fmt::format("{} takes the place of {} at node {}{}", label.what, to_string(other),
                  scope_.mesh.node_id(overruled.first_node), more),
      "of several blocks on a node the last one counts");
}

void VelocitySetter::set(std::uint32_t block) {
  const InitialVelocity& given = scope_.region.initial_velocities[block];
  const ConditionLabel label{"the initial velocity", given.name.location};
  const auto value = find_value(given, label);
  const auto direction = find_direction(given.direction, scope_);
  const auto nodes = find_nodes(given.set, label, scope_);
  if (!value || !direction) return;
  overruled_ = {};
  const Eigen::Matrix3Xd& x = scope_.mesh.coordinates();
  const NodalFields fields{x, x, velocity_};
  for (const NodeIndex node : nodes) {
    if (set_node(block, node,
                 along(*direction, value->at(scope_.start_time(), fields, node), x.col(node.value))))
      continue;
    scope_.diagnostics.add_error(label.location, fmt::format("{} has no finite value at node {}", label.what,
                                                             scope_.mesh.node_id(node)));
    return;
  }
  warn(label, overruled_);
}

}  // namespace

void set_initial_velocity(const ConditionScope& scope, Eigen::Matrix3Xd& velocity,
                          Eigen::Matrix3Xd* angular_velocity) {
  VelocitySetter setter(scope, velocity, angular_velocity);
  for (std::uint32_t i = 0; i < scope.region.initial_velocities.size(); ++i) setter.set(i);
}

}  // namespace contactsim
