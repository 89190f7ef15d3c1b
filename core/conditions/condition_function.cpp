// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/condition_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/errors.hpp"
#include "core/conditions/variable_name.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_inputs = 16;

}  // namespace

double NodalTable::at(double time, NodeIndex node) const {
  const auto column =
      static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  const StoredTime between = find_stored_time(times, time);
  const double first = values[between.first * nodes.size() + column];
  const double second = values[between.second * nodes.size() + column];
  return (1.0 - between.weight) * first + between.weight * second;
}

double ConditionFunction::at(double time) const {
  assert(!varies_in_space());
  const double value = factor_ * function_.evaluate(time);
  if (!std::isfinite(value)) {
    throw SolveError(time, fmt::format("the function of {} has no finite value", to_string(label_)));
  }
  return value;
}

double ConditionFunction::read(Input input, double time, const NodalFields& fields, NodeIndex node) {
  const auto i = static_cast<Eigen::Index>(node.value);
  switch (input.field) {
    case Input::Field::time:
      return time;
    case Input::Field::coordinates:
      return fields.coordinates(input.component, i);
    case Input::Field::model_coordinates:
      return fields.model_coordinates(input.component, i);
    case Input::Field::displacement:
      return fields.coordinates(input.component, i) - fields.model_coordinates(input.component, i);
    case Input::Field::velocity:
      return fields.velocity(input.component, i);
  }
  return time;
}

double ConditionFunction::at(double time, const NodalFields& fields, NodeIndex node) const {
  if (!varies_in_space()) return factor_ * function_.evaluate(time);
  if (table_) return factor_ * table_->at(time, node);
  std::array<double, max_inputs> values;
  for (std::size_t k = 0; k < inputs_.size(); ++k) values[k] = read(inputs_[k], time, fields, node);
  return factor_ * function_.evaluate(std::span<const double>(values.data(), inputs_.size()));
}

void ConditionFunction::fail(double time, const std::string& where) const {
  throw SolveError(time, fmt::format("the function of {} has no finite value {}", to_string(label_), where));
}

/// Looks up what a function reads; each step gives nothing after adding an error.
class ConditionFunctionMaker {
 public:
  ConditionFunctionMaker(const ConditionLabel& label, Diagnostics& diagnostics)
      : label_(label), diagnostics_(diagnostics) {}

  std::optional<ConditionFunction> make(Function function, double factor) const {
    ConditionFunction made(1.0, label_);
    for (const FunctionInput& input : function.inputs()) {
      const auto found = find_input(input);
      if (!found) return std::nullopt;
      made.inputs_.push_back(*found);
    }
    if (made.inputs_.size() > max_inputs) return fail_count(function.inputs()[max_inputs].variable);
    made.function_ = std::move(function);
    made.factor_ = factor;
    return made;
  }

 private:
  using Input = ConditionFunction::Input;

  std::nullopt_t fail_count(const DeckName& variable) const {
    diagnostics_.add_error(variable.location, fmt::format("the function of {} reads more than {} numbers",
                                                          label_.what, max_inputs));
    return std::nullopt;
  }

  std::optional<Input> find_input(const FunctionInput& input) const;

  const ConditionLabel& label_;
  Diagnostics& diagnostics_;
};

std::optional<ConditionFunction::Input> ConditionFunctionMaker::find_input(const FunctionInput& input) const {
  using Field = Input::Field;
  static constexpr std::pair<std::string_view, Field> fields[] = {
      {"coordinates", Field::coordinates},
      {"model_coordinates", Field::model_coordinates},
      {"displacement", Field::displacement},
      {"velocity", Field::velocity}};
  const auto [name, own_component] = split_variable(input.variable.text);
  const bool is_time = input.source == ExpressionSource::global && name == "time" && own_component.empty();
  if (is_time) return Input{Field::time, 0};
  const bool is_nodal =
      input.source == ExpressionSource::nodal || input.source == ExpressionSource::nodal_vector;
  const auto component = find_component(input.component.empty() ? own_component : input.component, 3);
  for (const auto& [known, field] : fields) {
    if (is_nodal && component && name == known) return Input{field, static_cast<Eigen::Index>(*component)};
  }
  diagnostics_.add_error(
      input.variable.location,
      fmt::format("the function of {} reads '{}', which conditions do not know", label_.what,
                  input.variable.text),
      "they know the global time and x, y and z of the nodal coordinates, model_coordinates, displacement "
      "and velocity",
      static_cast<int>(input.variable.text.size()));
  return std::nullopt;
}

std::optional<ConditionFunction> make_condition_function(const ScaledFunction& scaled, ConditionLabel label,
                                                         const ConditionScope& scope) {
  if (!scaled.function) return ConditionFunction(scaled.scale_factor, std::move(label));
  auto function = make_named_function(*scaled.function, scope.definition.functions, scope.diagnostics);
  if (!function) return std::nullopt;
  return ConditionFunctionMaker(label, scope.diagnostics).make(std::move(*function), scaled.scale_factor);
}

}  // namespace contactsim
