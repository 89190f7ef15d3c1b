// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/reports/wrap_text.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;

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
  if (comparison.differences.empty()) return wrap_text(comparison.kind + ": no differences\n");
  std::string text = fmt::format("{}: {}\n  first   {}\n  second  {}\n", comparison.kind,
                                 pluralize(comparison.differences.size(), "difference"), comparison.first,
                                 comparison.second);
  for (const Difference& difference : comparison.differences) text += "  " + difference.text + "\n";
  return wrap_text(text);
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
