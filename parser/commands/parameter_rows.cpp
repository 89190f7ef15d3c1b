// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/parameter_rows.hpp"

#include <fmt/format.h>

#include "parser/commands/rows.hpp"

namespace contactsim {

namespace {

double read_poissons_ratio(Arguments& arguments) {
  const Word* written = arguments.at_end() ? nullptr : &arguments.peek();
  const double ratio = arguments.real();
  if (ratio <= -1.0 || ratio >= 0.5) {
    arguments.fail(*written, fmt::format("'{}' must be greater than -1 and less than 0.5, found '{}'",
                                         arguments.what(), written->text));
  }
  return ratio;
}

PeriodModel read_period_model(Arguments& arguments) {
  PeriodModel model{arguments.reference(NameKind::friction_model), {}};
  arguments.expect("during");
  if (!arguments.accept("period")) arguments.expect("periods");
  arguments.skip_separator();
  model.periods = arguments.references(NameKind::time_stepping_block);
  return model;
}

/// What the parameter is without its line.
template <class V>
std::string default_text_of(const Parameter& parameter, const Reader<V>& reader) {
  if (!parameter.default_text.empty()) return parameter.default_text;
  const V* value = std::get_if<V>(&parameter.by_default);
  return value != nullptr ? reader.show(*value) : "none";
}

/// The value of a line as the model has it: a real number times the factor of its parameter.
template <class V>
V scaled_value(V value, [[maybe_unused]] double factor) {
  if constexpr (std::is_same_v<V, double>) value *= factor;
  return value;
}

/// A line with one value.
template <class V>
Row<ParameterValues> value_row(const Parameter& parameter, const Reader<V>& reader) {
  RowText text{parameter.phrase, "= " + reader.syntax, parameter.help, default_text_of(parameter, reader)};
  text.is_single = true;
  if (reader.references) text.references.push_back(*reader.references);
  const std::string target = parameter.stands_for.empty() ? parameter.phrase : parameter.stands_for;
  return {std::move(text), [read_value = reader.read, target, factor = parameter.factor](
                               Arguments& arguments, ParameterValues& values) {
            values.set(target, scaled_value<V>(read_value(arguments), factor));
          }};
}

Row<ParameterValues> models_row(const Parameter& parameter) {
  return row<ParameterValues>(
             parameter.phrase, "= <model> DURING PERIODS <period> ...",
             [phrase = parameter.phrase](Arguments& arguments, ParameterValues& values) {
               values.add(phrase, read_period_model(arguments));
             },
             parameter.help, "none")
      .references(NameKind::friction_model)
      .references(NameKind::time_stepping_block);
}

Row<ParameterValues> row_of(const Parameter& parameter) {
  static const Reader<double> poissons_ratio{"<real > -1, < 0.5>", read_poissons_ratio, read::real.show};
  switch (parameter.kind) {
    case ParameterKind::real:
      return value_row(parameter, read::real);
    case ParameterKind::positive:
      return value_row(parameter, read::positive);
    case ParameterKind::non_negative:
      return value_row(parameter, read::non_negative);
    case ParameterKind::poissons_ratio:
      return value_row(parameter, poissons_ratio);
    case ParameterKind::count:
      return value_row(parameter, read::positive_integer);
    case ParameterKind::word:
      return value_row(parameter, choice_of<std::int64_t>(parameter.words));
    case ParameterKind::function:
      return value_row(parameter, read::name_of(NameKind::function));
    case ParameterKind::coordinate_system:
      return value_row(parameter, read::name_of(NameKind::coordinate_system));
    case ParameterKind::friction_model:
      return value_row(parameter, read::name_of(NameKind::friction_model));
    case ParameterKind::models_by_period:
      return models_row(parameter);
    case ParameterKind::ignored:
      return ignored<ParameterValues>(parameter.phrase, "= <words>", parameter.help);
    case ParameterKind::refused:
      break;
  }
  return refused<ParameterValues>(parameter.phrase, "= <words>", parameter.help);
}

}  // namespace

Table<ParameterValues> make_parameter_table(std::span<const Parameter> parameters) {
  std::vector<Row<ParameterValues>> rows;
  for (const Parameter& parameter : parameters) {
    Row<ParameterValues> row = row_of(parameter);
    if (!parameter.spelling.empty()) row = std::move(row).or_spelled(parameter.spelling);
    if (parameter.is_required) row = std::move(row).required();
    rows.push_back(std::move(row));
  }
  return {std::move(rows)};
}

}  // namespace contactsim
