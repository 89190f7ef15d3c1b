// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/definition/expression.hpp"
#include "core/functions/expression_functions.hpp"
#include "parser/aprepro/values.hpp"
#include "parser/text/text_file.hpp"

namespace contactsim {

/// A string of an expression may not grow past this.
constexpr std::size_t max_aprepro_string = std::size_t{1} << 20;

/// What expressions read and change.
struct ApreproState {
  ApreproVariables variables;
  std::mt19937_64 random{0};     ///< of rand(); the same deck gives the same numbers on every run
  bool makes_immutable = false;  ///< between {IMMUTABLE(ON)} and {IMMUTABLE(OFF)}
  FileReader read_file = read_no_file;
  std::size_t work = 0;  ///< characters handled so far, against endless loops
  std::size_t max_work = std::size_t{1} << 28;
  std::function<void(std::string_view id, const ExpressionError&)> warn = {};
};

/// A function that expressions may call: one row of the table.
struct ApreproFunction {
  using Arguments = std::span<const ApreproValue>;
  using OfNumbers = ExpressionFunction::Body;
  using General = ApreproValue (*)(Arguments, ApreproState&);

  std::string_view name;
  std::string_view parameters;  ///< as the user reads them, "x, y"
  std::string_view types;       ///< one letter per argument: n a number, s a string
  std::string_view help;        ///< one line; of a refused function why it is refused
  std::variant<std::monostate, OfNumbers, General> call;  ///< monostate: known to Aprepro, refused
};

/// All rows, those shared with expression_functions() among them, sorted by name.
std::span<const ApreproFunction> aprepro_functions();

/// The row of a name, case mattering; null when there is none.
const ApreproFunction* find_aprepro_function(std::string_view name);

}  // namespace contactsim
