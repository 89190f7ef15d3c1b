// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/calls.hpp"

#include <fmt/format.h>

#include <cmath>

namespace contactsim {

namespace {

using F = ApreproFunction;
using Arguments = ApreproFunction::Arguments;

double number(const ApreproValue& value) { return std::get<double>(value); }

/// Calls the row's function with arguments that have been checked.
struct Caller {
  Arguments arguments;
  ApreproState& state;
  ApreproValue operator()(std::monostate) const { return 0.0; }
  ApreproValue operator()(F::OfOne f) const { return f(number(arguments[0])); }
  ApreproValue operator()(F::OfTwo f) const { return f(number(arguments[0]), number(arguments[1])); }
  ApreproValue operator()(F::OfFour f) const {
    return f(number(arguments[0]), number(arguments[1]), number(arguments[2]), number(arguments[3]));
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
    throw ApreproError{0, 0, fmt::format("'{}' has no finite value here", function.name)};
  }
  if (found == nullptr && std::get<std::string>(value).size() > max_aprepro_string) {
    throw ApreproError{0, 0, fmt::format("'{}' gives a string of more than 1 MiB", function.name)};
  }
}

}  // namespace

ApreproValue call_aprepro_function(const ApreproFunction& function, const ApreproToken& name,
                                   Arguments arguments, ApreproState& state) {
  const int length = static_cast<int>(name.text.size());
  const std::string obstacle = find_obstacle(function, arguments);
  if (!obstacle.empty()) throw ApreproError{name.offset, length, obstacle};
  try {
    ApreproValue value = std::visit(Caller{arguments, state}, function.call);
    check_result(function, value);
    return value;
  } catch (const ApreproError& error) {
    throw ApreproError{name.offset, length, error.text, error.hint};
  }
}

}  // namespace contactsim
