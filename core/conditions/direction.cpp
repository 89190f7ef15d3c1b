// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/direction.hpp"

#include <fmt/format.h>

#include "core/base/find_definition.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

std::optional<Eigen::Vector3d> find_unit(const DeckName& name, const ConditionScope& scope) {
  const auto* found = find_definition(scope.definition.directions, name, "direction", scope.diagnostics);
  if (found == nullptr) return std::nullopt;
  return found->vector.stableNormalized();
}

std::optional<Axis> find_axis(const DeckName& name, const ConditionScope& scope) {
  const auto* found = find_definition(scope.definition.axes, name, "axis", scope.diagnostics);
  if (found == nullptr) return std::nullopt;
  const auto* point = find_definition(scope.definition.points, found->point, "point", scope.diagnostics);
  if (point == nullptr) return std::nullopt;
  if (found->direction) {
    const auto unit = find_unit(*found->direction, scope);
    return unit ? std::optional(Axis{point->coordinates, *unit}) : std::nullopt;
  }
  const auto* second =
      find_definition(scope.definition.points, *found->second_point, "point", scope.diagnostics);
  if (second == nullptr) return std::nullopt;
  const Eigen::Vector3d unit = (second->coordinates - point->coordinates).stableNormalized();
  if (unit.norm() > 0.5) return Axis{point->coordinates, unit};
  scope.diagnostics.add_error(found->name.location,
                              fmt::format("the axis '{}' runs through one point only", found->name.text),
                              "its two points lie at one place");
  return std::nullopt;
}

}  // namespace

std::optional<Direction> find_direction(const DirectionChoice& choice, const ConditionScope& scope) {
  if (choice.direction) return find_unit(*choice.direction, scope);
  if (choice.cylindrical_axis) return find_axis(*choice.cylindrical_axis, scope);
  return Components{choice.components};
}

std::vector<Eigen::Vector3d> unit_vectors(const Direction& direction) {
  if (const auto* unit = std::get_if<Eigen::Vector3d>(&direction)) return {*unit};
  std::vector<Eigen::Vector3d> units;
  const Components components = std::get<Components>(direction);
  for (int axis = 0; axis < 3; ++axis) {
    if (components.is_set[static_cast<std::size_t>(axis)]) units.push_back(Eigen::Vector3d::Unit(axis));
  }
  return units;
}

Eigen::Vector3d sum_of_units(const Direction& direction) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& unit : unit_vectors(direction)) sum += unit;
  return sum;
}

}  // namespace contactsim
