// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;

/// A line of at most 120 columns, broken at blanks where there are some.
std::string wrap_line(std::string_view line) {
  constexpr std::size_t width = 120, indent = 6;
  std::string text;
  std::size_t room = width;
  while (line.size() > room) {
    const std::size_t blank = line.rfind(' ', room);
    const bool breaks_here = blank != std::string_view::npos && blank > room / 2;
    const std::size_t n = breaks_here ? blank : room;
    text += std::string(line.substr(0, n)) + "\n" + std::string(indent, ' ');
    line.remove_prefix(breaks_here ? n + 1 : n);
    room = width - indent;
  }
  return text + std::string(line) + "\n";
}

Json value_json(const Difference::Value& value) {
  if (const double* number = std::get_if<double>(&value))
    return std::isfinite(*number) ? Json(*number) : Json(nullptr);
  return std::visit([](const auto& other) { return Json(other); }, value);
}

}  // namespace

bool Tolerance::is_exceeded(double a, double b, double scale) const {
  if (a == b || (std::isnan(a) && std::isnan(b))) return false;
  // Negated, so that one that is not a number differs from one that is.
  return !(std::abs(a - b) <= atol + rtol * (std::isfinite(scale) ? scale : 0.0));
}

bool Tolerance::is_exceeded(double a, double b) const {
  return is_exceeded(a, b, std::max(std::abs(a), std::abs(b)));
}

std::string format_value(double value) { return fmt::format("{:.9g}", value); }

std::string format_comparison(const FileComparison& comparison) {
  if (comparison.differences.empty()) return wrap_line(fmt::format("{}: no differences", comparison.kind));
  std::string text = wrap_line(
      fmt::format("{}: {}", comparison.kind, pluralize(comparison.differences.size(), "difference")));
  text += wrap_line("  first   " + comparison.first) + wrap_line("  second  " + comparison.second);
  for (const Difference& difference : comparison.differences) text += wrap_line("  " + difference.text);
  return text;
}

std::string format_comparison_json(const FileComparison& comparison) {
  Json differences = Json::array();
  for (const Difference& difference : comparison.differences) {
    Json one{{"kind", difference.kind}};
    for (const auto& [name, value] : difference.fields) one[name] = value_json(value);
    differences.push_back(std::move(one));
  }
  const Json json{{"schema", "contactsim-diff/1"},
                  {"kind", comparison.kind},
                  {"first", comparison.first},
                  {"second", comparison.second},
                  {"same", comparison.differences.empty()},
                  {"differences", std::move(differences)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace contactsim
