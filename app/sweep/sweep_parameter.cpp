// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/sweep_parameter.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/compare/read_number.hpp"
#include "app/reports/csv.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

namespace {

/// Steps that round-off may take from, or add to, a range.
constexpr double step_tolerance = 1e-6;

double n_steps(const SweepParameter::Range& range) { return (range.last - range.first) / range.step; }

std::vector<std::string> split_at_colons(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// A range, when the text has its form and begins with a number; else nothing.
std::optional<SweepParameter::Range> parse_range(const std::string& parameter, const std::string& text) {
  const std::vector<std::string> parts = split_at_colons(text);
  const auto first = read_number(parts[0]);
  if (parts.size() < 2 || !first) return std::nullopt;
  const auto refuse = [&](const char* why) { refuse_sweep(fmt::format("-D {}: {}", parameter, why)); };
  const auto last = read_number(parts[1]);
  const auto step = parts.size() == 3 ? read_number(parts[2]) : std::optional(0.0);
  if (parts.size() > 3 || !last || !step) refuse("a range is first:last:step, three numbers");
  const SweepParameter::Range range{*first, *last, *step};
  if (!std::isfinite(*first) || !std::isfinite(*last) || !std::isfinite(*step))
    refuse("a range has finite numbers");
  if (parts.size() == 2) return range;
  if (*step == 0.0) refuse("the step is zero");
  if (n_steps(range) < 0.0) refuse("the step leads away from the last value");
  return range;
}

}  // namespace

void refuse_sweep(const std::string& what) {
  Diagnostics mistake;
  mistake.add_error({}, what);
  throw DeckError(mistake);
}

std::string format_parameter(double value) { return fmt::format("{:.12g}", value == 0.0 ? 0.0 : value); }

double SweepParameter::n_values() const {
  if (!range) return static_cast<double>(values.size());
  if (range->step == 0.0) return 0.0;
  return std::floor(n_steps(*range) + step_tolerance) + 1.0;
}

std::string SweepParameter::value(std::size_t i) const {
  if (!range) return values[i];
  const double at = range->first + static_cast<double>(i) * range->step;
  const bool is_last = std::abs(at - range->last) < step_tolerance * std::abs(range->step);
  // What is zero but for round-off is zero.
  const bool is_zero = std::abs(at) < step_tolerance * std::abs(range->step);
  return format_parameter(is_last ? range->last : is_zero ? 0.0 : at);
}

SweepParameter parse_sweep_parameter(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    refuse_sweep(fmt::format("-D {}: expected name=value, name=a,b,c or name=first:last:step", text));
  SweepParameter parameter;
  parameter.name = text.substr(0, equals);
  const std::string value = text.substr(equals + 1);
  parameter.range = parse_range(text, value);
  if (parameter.range) return parameter;
  const std::vector<CsvLine> lines = split_csv(value);
  if (lines.size() > 1) refuse_sweep(fmt::format("-D {}: the values stand on several lines", text));
  parameter.values = lines.empty() ? std::vector<std::string>{""} : lines[0].fields;
  if (parameter.values.size() == 1) parameter.values[0] = value;
  for (const std::string& one : parameter.values) {
    if (one.empty() && parameter.values.size() > 1)
      refuse_sweep(fmt::format("-D {}: the list has an empty value", text));
  }
  return parameter;
}

}  // namespace contactsim
