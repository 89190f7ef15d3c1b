// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/calls.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/functions/expression_operators.hpp"

namespace contactsim {

namespace {

using F = ApreproFunction;
using Arguments = ApreproFunction::Arguments;

/// Calls the row's function with arguments that have been checked.
struct Caller {
  Arguments arguments;
  ApreproState& state;
  ApreproValue operator()(std::monostate) const { return 0.0; }
  ApreproValue operator()(ExpressionFunction::Body body) const {
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < arguments.size(); ++i) numbers[i] = std::get<double>(arguments[i]);
    return body({numbers.data(), arguments.size()});
  }
  ApreproValue operator()(F::General f) const { return f(arguments, state); }
};

/// What keeps the call from being made, or "".
std::string find_obstacle(const F& function, Arguments arguments) {
  if (std::holds_alternative<std::monostate>(function.call)) {
    return fmt::format("Aprepro's '{}' is not supported: {}", function.name, function.help);
  }
  if (arguments.size() != function.types.size()) {
    return fmt::format("'{}({})' takes {} arguments, found {}", function.name, function.parameters,
                       function.types.size(), arguments.size());
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_number = std::holds_alternative<double>(arguments[i]);
    if (is_number == (function.types[i] == 'n')) continue;
    return fmt::format("argument {} of '{}({})' must be a {}, found a {}", i + 1, function.name,
                       function.parameters, is_number ? "string" : "number", is_number ? "number" : "string");
  }
  return "";
}

void check_result(const F& function, const ApreproValue& value) {
  const double* found = std::get_if<double>(&value);
  if (found != nullptr && !std::isfinite(*found)) {
    throw ExpressionError{0, 0, fmt::format("'{}' has no finite value here", function.name)};
  }
  if (found == nullptr && std::get<std::string>(value).size() > max_aprepro_string) {
    throw ExpressionError{0, 0, fmt::format("'{}' gives a string of more than 1 MiB", function.name)};
  }
}

}  // namespace

ApreproValue call_aprepro_function(const ApreproFunction& function, const ExpressionItem& name,
                                   Arguments arguments, ApreproState& state) {
  const std::string obstacle = find_obstacle(function, arguments);
  if (!obstacle.empty()) fail_at(name, obstacle);
  try {
    ApreproValue value = std::visit(Caller{arguments, state}, function.call);
    check_result(function, value);
    return value;
  } catch (const ExpressionError& error) {
    fail_at(name, error.text, error.hint);
  }
}

}  // namespace contactsim
