// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/initial_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/conditions/entity_elements.hpp"
#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/stored_values.hpp"

namespace contactsim {

namespace {

constexpr const char* condition_words = "the initial condition";

ConditionLabel label_of(const InitialCondition& condition) {
  return {condition_words, condition.name.location};
}

double value_at(const std::vector<double>& column, std::size_t i) {
  return column.size() == 1 ? column.front() : column[i];
}

}  // namespace

void InitialConditionSetter::report(const DeckName& name, std::string text, std::string hint) const {
  scope_.diagnostics.add_error(name.location, std::move(text), std::move(hint),
                               static_cast<int>(name.text.size()));
}

void InitialConditionSetter::set(const InitialCondition& condition) {
  const DeckName& variable = *condition.variable;
  if (split_variable(variable.text).name == "temperature") {
    scope_.diagnostics.add_warning("condition-ignored", variable.location,
                                   "the initial temperature has no effect: nothing depends on it");
    return;
  }
  if (condition.type == VariableType::node) return set_nodal(condition);
  if (condition.type == VariableType::element) return set_element(condition);
  scope_.diagnostics.add_error(condition.name.location,
                               "the initial condition is not of a node or element variable, which it must be",
                               "write VARIABLE TYPE = NODE or ELEMENT");
}

std::optional<InitialConditionSetter::Wanted> InitialConditionSetter::find_wanted(
    const DeckName& variable, std::size_t n_components) const {
  Wanted wanted{split_variable(variable.text), n_components, std::vector<std::size_t>(n_components)};
  std::iota(wanted.components.begin(), wanted.components.end(), std::size_t{0});
  if (wanted.variable.component.empty()) return wanted;
  const auto component = find_component(wanted.variable.component, n_components);
  if (component) {
    wanted.components = {*component};
    return wanted;
  }
  report(variable,
         fmt::format("'{}' has no component '{}'", wanted.variable.name, wanted.variable.component));
  return std::nullopt;
}

/// Of a picked component the file's variable is a scalar.
std::optional<InitialConditionSetter::Columns> InitialConditionSetter::read_columns(
    const InitialCondition& condition, const Wanted& wanted) const {
  auto columns = read_stored(condition.mesh_variable, condition.type == VariableType::element,
                             wanted.components.size(), scope_);
  if (!columns) return std::nullopt;
  for (std::vector<double>& column : *columns) {
    for (double& value : column) value *= condition.scale_factor;
  }
  return columns;
}

std::optional<InitialConditionSetter::Columns> InitialConditionSetter::find_columns(
    const InitialCondition& condition, const Wanted& wanted) const {
  if (condition.mesh_variable.variable) return read_columns(condition, wanted);
  const std::size_t n = wanted.components.size();
  if (condition.magnitude.size() != n) {
    report(*condition.variable,
           fmt::format("'{}' needs {} for MAGNITUDE, found {}", condition.variable->text,
                       n == 1 ? "one number" : fmt::format("{} numbers", n), condition.magnitude.size()));
    return std::nullopt;
  }
  Columns columns;
  for (const double value : condition.magnitude) columns.push_back({value});
  return columns;
}

void InitialConditionSetter::set_nodal(const InitialCondition& condition) {
  const DeckName& name = *condition.variable;
  const auto wanted = find_wanted(name, 3);
  const auto nodes = find_nodes(condition.set, label_of(condition), scope_);
  if (!wanted) return;
  const bool is_velocity = wanted->variable.name == "velocity";
  if (!is_velocity && wanted->variable.name != "displacement") {
    return report(name, fmt::format("nodes have no '{}' that could be set at the start", name.text),
                  "velocity and displacement can");
  }
  const auto columns = find_columns(condition, *wanted);
  if (!columns) return;
  Eigen::Matrix3Xd& target = is_velocity ? state_.velocity : state_.displacement;
  if (target.cols() == 0) target.setZero(3, scope_.mesh.n_nodes());
  for (std::size_t k = 0; k < columns->size(); ++k) {
    for (const NodeIndex node : nodes) {
      const double value = value_at((*columns)[k], node.value);
      if (!std::isfinite(value)) {
        return report(name, fmt::format("the initial '{}' is not finite at node {}", name.text,
                                        scope_.mesh.node_id(node)));
      }
      target(static_cast<Eigen::Index>(wanted->components[k]), node.value) = value;
    }
  }
}

std::vector<std::string> InitialConditionSetter::element_variables() const {
  std::vector<std::string> names{"stress"};
  for (const ModelBlock& block : blocks_) {
    for (const StateVariable& variable : block.properties.law.kind().variables) {
      if (std::find(names.begin(), names.end(), variable.name) == names.end())
        names.emplace_back(variable.name);
    }
  }
  return names;
}

/// 0 when no material has the variable.
std::size_t InitialConditionSetter::count_components(const std::string& element_variable) const {
  if (element_variable == "stress") return 6;
  for (const ModelBlock& block : blocks_) {
    for (const StateVariable& variable : block.properties.law.kind().variables) {
      if (variable.name == element_variable) return variable.n_components;
    }
  }
  return 0;
}

void InitialConditionSetter::check_has(const std::string& variable, std::span<const ElementIndex> elements,
                                       const DeckName& name) const {
  if (variable == "stress") return;
  for (const ModelBlock& block : blocks_) {
    const auto known = block.properties.law.kind().variables;
    const bool has = std::any_of(known.begin(), known.end(),
                                 [&](const StateVariable& one) { return one.name == variable; });
    const auto first = std::lower_bound(elements.begin(), elements.end(), block.first_element);
    const bool is_meant =
        first != elements.end() && first->value < block.first_element.value + block.n_elements;
    if (!is_meant || has) continue;
    report(name, fmt::format("the material of '{}' has no '{}'",
                             scope_.mesh.name({EntityKind::block, block.mesh_block}), variable));
  }
}

void InitialConditionSetter::set_element(const InitialCondition& condition) {
  const DeckName& name = *condition.variable;
  const std::string variable = split_variable(name.text).name;
  const auto elements = find_elements(condition.set, label_of(condition), scope_);
  const std::size_t n_components = count_components(variable);
  if (n_components == 0) {
    const auto known = element_variables();
    return report(name, fmt::format("elements have no '{}' that could be set at the start", name.text),
                  fmt::format("they have {}", fmt::join(known, ", ")));
  }
  check_has(variable, elements, name);
  const auto wanted = find_wanted(name, n_components);
  const auto columns = wanted ? find_columns(condition, *wanted) : std::nullopt;
  if (!columns) return;
  for (std::size_t k = 0; k < columns->size(); ++k) {
    InitialElementValues values{
        variable, wanted->components[k],
        std::vector<double>(scope_.mesh.n_elements(), std::numeric_limits<double>::quiet_NaN())};
    for (const ElementIndex element : elements) {
      values.values[element.value] = value_at((*columns)[k], element.value);
      if (std::isfinite(values.values[element.value])) continue;
      return report(name, fmt::format("the initial '{}' is not finite, or missing, at element {}", name.text,
                                      scope_.mesh.element_id(element)));
    }
    state_.element_values.push_back(std::move(values));
  }
}

}  // namespace contactsim
