// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "parser/commands/function_commands.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

void add(Diagnostics& diagnostics, const FunctionDefinition& function, const DeckLocation& at,
         std::string_view what, std::string hint = "") {
  diagnostics.add_error(at, fmt::format("the function '{}' {}", function.name.text, what), std::move(hint));
}

void check_constant(const FunctionDefinition& function, Diagnostics& diagnostics) {
  if (function.values.size() != 1) {
    add(diagnostics, function, function.name.location,
        fmt::format("of type constant needs one value, found {}", function.values.size()));
  }
}

/// The first abscissa that is less than the one before, or the first line that is no pair, is reported: the
/// lines after it are likely wrong in the same way.
void check_points(const FunctionDefinition& function, Diagnostics& diagnostics) {
  if (function.values.empty()) {
    add(diagnostics, function, function.name.location, "has no values", "add a VALUES block");
  }
  double last = -std::numeric_limits<double>::infinity();
  for (const FunctionValue& value : function.values) {
    const bool is_pair = !std::isnan(value.abscissa) && !std::isnan(value.ordinate) && value.further.empty();
    if (!is_pair) return add(diagnostics, function, value.location, "needs two numbers on each line");
    if (value.abscissa < last) {
      return add(diagnostics, function, value.location,
                 fmt::format("has an abscissa that decreases from {} to {}", last, value.abscissa));
    }
    last = value.abscissa;
  }
}

}  // namespace

void check_used_function(const FunctionDefinition& function, Diagnostics& diagnostics) {
  if (!function.type) {
    return add(diagnostics, function, function.name.location, "has no type",
               "add a line such as TYPE = ANALYTIC");
  }
  switch (*function.type) {
    case FunctionType::constant:
      return check_constant(function, diagnostics);
    case FunctionType::piecewise_linear:
    case FunctionType::piecewise_constant:
      return check_points(function, diagnostics);
    case FunctionType::analytic:
      if (!function.expression) {
        add(diagnostics, function, function.name.location, "has no expression", "add EVALUATE EXPRESSION");
      }
      return;
    case FunctionType::piecewise_analytic:
    case FunctionType::piecewise_multivariate:
    case FunctionType::multicolumn_piecewise_linear:
    case FunctionType::xtable:
    case FunctionType::polynomial:
    case FunctionType::haversine_spike:
      return add(diagnostics, function, function.type_location, "has a type that is not supported",
                 "use piecewise linear or analytic");
  }
}

}  // namespace contactsim
