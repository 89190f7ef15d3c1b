// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/stored_values.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include "core/conditions/variable_name.hpp"

namespace contactsim {

namespace {

/// Numbers that a condition may hold at most: one gigabyte.
constexpr std::size_t max_values = std::size_t{1} << 27;

std::vector<double> read_at(const StoredVariableKind& kind, std::size_t variable, const StoredTime& time) {
  std::vector<double> values = kind.read(variable, time.first);
  if (time.weight == 0.0) return values;
  const std::vector<double> after = kind.read(variable, time.second);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (1.0 - time.weight) * values[i] + time.weight * after[i];
  return values;
}

std::nullopt_t fail(const DeckName& name, std::string text, std::string hint, const ConditionScope& scope) {
  scope.diagnostics.add_error(name.location, std::move(text), std::move(hint),
                              static_cast<int>(name.text.size()));
  return std::nullopt;
}

bool has_results(const ConditionScope& scope) {
  return scope.stored != nullptr && !scope.stored->times.empty();
}

std::nullopt_t fail_unknown(const DeckName& name, const char* what, std::size_t n_components,
                            const ConditionScope& scope) {
  if (!has_results(scope)) return fail(name, "the mesh file holds no results to read from", "", scope);
  const std::string components =
      n_components > 1 ? fmt::format(" with {} components", n_components) : std::string();
  const auto& kind = what == std::string_view("element") ? scope.stored->element : scope.stored->nodal;
  return fail(name, fmt::format("the mesh file has no {} variable '{}'{}", what, name.text, components),
              suggest(name.text, kind.names), scope);
}

/// The one stored time that a TIME line means.
StoredTime fixed_time(const MeshVariable& variable, const ConditionScope& scope) {
  const std::vector<double>& times = scope.stored->times;
  const std::size_t last = times.size() - 1;
  switch (variable.time) {
    case MeshVariable::Time::first:
      return {0, 0, 0.0};
    case MeshVariable::Time::last:
      return {last, last, 0.0};
    case MeshVariable::Time::given:
      return find_stored_time(times, variable.given_time);
    case MeshVariable::Time::run_time:
      break;
  }
  return find_stored_time(times, scope.start_time());
}

void append_nodes(const std::vector<double>& values, const std::vector<NodeIndex>& nodes,
                  std::vector<double>& row) {
  for (const NodeIndex node : nodes) row.push_back(values[node.value]);
}

NodalTable read_table(const MeshVariable& wanted, std::size_t variable, const ValueTarget& target,
                      const ConditionScope& scope) {
  const StoredVariables& stored = *scope.stored;
  NodalTable table{{0.0}, target.nodes, {}};
  if (wanted.time != MeshVariable::Time::run_time) {
    append_nodes(read_at(stored.nodal, variable, fixed_time(wanted, scope)), target.nodes, table.values);
    return table;
  }
  table.times = stored.times;
  for (std::size_t time = 0; time < stored.times.size(); ++time)
    append_nodes(stored.nodal.read(variable, time), target.nodes, table.values);
  return table;
}

/// The variables of components that are set; one for all of them when there is one of the very name.
std::optional<std::vector<std::size_t>> find_variables(const DeckName& name,
                                                       const std::array<bool, 3>& components,
                                                       const ConditionScope& scope) {
  if (!has_results(scope)) return std::nullopt;
  if (auto whole = find_stored(scope.stored->nodal, name.text, 1)) return whole;
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!components[c]) continue;
    const std::string letters(component_letters(c, 3));
    auto one = find_stored(scope.stored->nodal, name.text + "_" + letters, 1);
    if (!one) one = find_stored(scope.stored->nodal, name.text + letters, 1);
    if (!one) return std::nullopt;
    found.push_back(one->front());
  }
  return found.empty() ? std::nullopt : std::optional(found);
}

std::optional<std::vector<ConditionFunction>> read_functions(double factor, const MeshVariable& wanted,
                                                             const ValueTarget& target,
                                                             const ConditionScope& scope) {
  const DeckName& name = *wanted.variable;
  if (wanted.object == MeshVariable::Object::face)
    return fail(name, target.label.what + " can read nodal variables only", "write OBJECT TYPE = NODE",
                scope);
  const auto variables = find_variables(name, target.components, scope);
  if (!variables) return fail_unknown(name, "nodal", 1, scope);
  const bool all_times = wanted.time == MeshVariable::Time::run_time;
  const std::size_t n_rows = (all_times ? scope.stored->times.size() : 1) * variables->size();
  if (n_rows * target.nodes.size() > max_values) {
    return fail(name,
                fmt::format("'{}' has {} stored values for {} nodes, which is too much to hold", name.text,
                            n_rows, target.nodes.size()),
                "a TIME line reads one time only", scope);
  }
  std::vector<ConditionFunction> functions;
  for (const std::size_t variable : *variables)
    functions.emplace_back(read_table(wanted, variable, target, scope), factor, target.label);
  return functions;
}

}  // namespace

std::optional<StoredComponents> read_stored(const MeshVariable& variable, bool is_element,
                                            std::size_t n_components, const ConditionScope& scope) {
  const DeckName& name = *variable.variable;
  const char* what = is_element ? "element" : "nodal";
  if (!has_results(scope)) return fail_unknown(name, what, n_components, scope);
  const StoredVariableKind& kind = is_element ? scope.stored->element : scope.stored->nodal;
  const auto found = find_stored(kind, name.text, n_components);
  if (!found) return fail_unknown(name, what, n_components, scope);
  StoredComponents components;
  for (const std::size_t component : *found)
    components.push_back(read_at(kind, component, fixed_time(variable, scope)));
  return components;
}

std::optional<std::vector<ConditionFunction>> find_condition_values(const ScaledFunction& function,
                                                                    const MeshVariable& variable,
                                                                    const ValueTarget& target,
                                                                    const ConditionScope& scope) {
  if (variable.variable) return read_functions(function.scale_factor, variable, target, scope);
  auto value = make_condition_function(function, target.label, scope);
  return value ? std::optional(std::vector{std::move(*value)}) : std::nullopt;
}

}  // namespace contactsim
