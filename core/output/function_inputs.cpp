// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/function_inputs.hpp"

#include <fmt/format.h>

#include <charconv>

namespace contactsim {

namespace {

VariableLocation location_of(ExpressionSource source) {
  switch (source) {
    case ExpressionSource::global:
      return VariableLocation::global;
    case ExpressionSource::nodal:
    case ExpressionSource::nodal_vector:
    case ExpressionSource::nodal_tensor:
    case ExpressionSource::nodal_sym_tensor:
      return VariableLocation::nodal;
    case ExpressionSource::element:
    case ExpressionSource::element_vector:
    case ExpressionSource::element_tensor:
    case ExpressionSource::element_sym_tensor:
      return VariableLocation::element;
    case ExpressionSource::face:
      break;
  }
  return VariableLocation::face;
}

void warn(Diagnostics& diagnostics, const DeckName& at, std::string text) {
  diagnostics.add_warning("output-function-input", at.location, std::move(text), "",
                          static_cast<int>(at.text.size()));
}

// The one number that an input reads at a location.
std::optional<VariableSelection> find_input(const FunctionInput& input, FieldLocation location,
                                            const OutputVariables& variables, Diagnostics& diagnostics) {
  VariableReference reference = split_reference(input.variable);
  if (!input.component.empty()) reference.component = input.component;
  const auto selection = find_selection(variables, location_of(input.source), reference, diagnostics);
  if (!selection) return std::nullopt;
  if (selection->variable->location != location && selection->variable->location != FieldLocation::global) {
    warn(diagnostics, input.variable,
         fmt::format("a {} value cannot be made from the {} variable {}", to_string(location),
                     to_string(selection->variable->location), input.variable.text));
    return std::nullopt;
  }
  if (selection->n_components() != 1) {
    warn(diagnostics, input.variable, fmt::format("{} is not one number", input.variable.text));
    return std::nullopt;
  }
  return selection;
}

}  // namespace

VariableReference split_reference(const DeckName& word) {
  const std::string_view text = word.text;
  const std::size_t open = text.find('(');
  VariableReference reference{{std::string(text.substr(0, open)), word.location}, "", std::nullopt};
  if (open == std::string_view::npos || text.back() != ')') return reference;
  const std::string_view inside = text.substr(open + 1, text.size() - open - 2);
  const std::size_t comma = inside.find(',');
  const auto means_all = [](std::string_view part) { return part == ":" || part == "*"; };
  if (!means_all(inside.substr(0, comma))) reference.component = fold(inside.substr(0, comma));
  if (comma == std::string_view::npos || means_all(inside.substr(comma + 1))) return reference;
  std::int64_t point = 0;
  const std::string_view number = inside.substr(comma + 1);
  std::from_chars(number.data(), number.data() + number.size(), point);
  if (point > 0) reference.integration_point = point;
  return reference;
}

void VariableFunction::evaluate(const OutputContext& context, const EntityRange& range,
                                std::span<double> values) const {
  if (inputs_.empty()) {
    for (double& value : values) value = function_.evaluate(context.state.time);
    return;
  }
  std::vector<std::vector<double>> columns;
  for (const VariableSelection& input : inputs_) {
    const bool is_global = input.variable->location == FieldLocation::global;
    const EntityRange own = is_global ? EntityRange{} : range;
    fill(input, context, own, columns.emplace_back(own.count));
    if (is_global) columns.back().resize(range.count, columns.back()[0]);
  }
  std::vector<double> row(inputs_.size());
  for (std::size_t i = 0; i < range.count; ++i) {
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = columns[k][i];
    values[i] = function_.evaluate(row);
  }
}

std::optional<VariableFunction> make_variable_function(Function function, FieldLocation location,
                                                       const OutputVariables& variables,
                                                       Diagnostics& diagnostics) {
  std::vector<VariableSelection> inputs;
  for (const FunctionInput& input : function.inputs()) {
    const auto selection = find_input(input, location, variables, diagnostics);
    if (!selection) return std::nullopt;
    inputs.push_back(*selection);
  }
  return VariableFunction(std::move(function), std::move(inputs));
}

}  // namespace contactsim
