// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace contactsim {

/// The kinds of expressions: those of BEGIN FUNCTION and user output, which read numbers in every step, and
/// Aprepro's, which know strings and are evaluated once.
enum class ExpressionDialects : std::uint8_t { function, aprepro, all };

/// Whether what belongs to `dialects` is part of one of them.
constexpr bool has_dialect(ExpressionDialects dialects, ExpressionDialects one) {
  return dialects == ExpressionDialects::all || dialects == one;
}

/// A function that expressions may call: one row of the table.
struct ExpressionFunction {
  using Body = double (*)(std::span<const double> arguments);

  std::string_view name;        ///< in lower case
  std::string_view parameters;  ///< as the user reads them, "x, y"
  std::size_t min_arguments = 1;
  std::size_t max_arguments = 1;
  Body body = nullptr;    ///< null when the function is refused
  std::string_view help;  ///< one line; of a refused function why it is refused
  ExpressionDialects dialects = ExpressionDialects::function;  ///< all: Aprepro's function is the same
};

/// All rows, sorted by name: every function of BEGIN FUNCTION, and so some of Aprepro's.
/// Source: Trilinos STK expreval, whose names and definitions Sierra decks use.
std::span<const ExpressionFunction> expression_functions();

/// The row of a name in lower case; null when there is none.
const ExpressionFunction* find_expression_function(std::string_view name);

/// The value of PI, TWO_PI, E, TRUE or FALSE, given in lower case; nothing for another name.
std::optional<double> find_expression_constant(std::string_view name);

}  // namespace contactsim
