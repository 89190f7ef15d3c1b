// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/definition/expression.hpp"
#include "core/functions/expression_functions.hpp"

namespace contactsim {

/// One step of an expression's postfix program. Values are pushed on a stack and taken from it.
struct ExpressionStep {
  enum class Kind : std::uint8_t {
    number,        ///< pushes `number`
    input,         ///< pushes input `index`
    local,         ///< pushes assigned name `index`
    store,         ///< sets assigned name `index` to the top, which stays
    drop,          ///< takes the top off
    call,          ///< takes `index` arguments off, pushes the value of `body`
    jump,          ///< goes to step `index`
    jump_if_false  ///< takes the top off, goes to step `index` if it is 0
  };
  Kind kind = Kind::number;
  std::uint32_t index = 0;
  double number = 0.0;
  ExpressionFunction::Body body = nullptr;
};

/// A compiled expression: the value of its last statement as a function of its inputs. Nothing is allocated
/// when it is evaluated, and the same inputs give the same bits.
class Expression {
 public:
  /// The value, NaN or infinite where the expression has no finite one. Of a ?: only the chosen side runs.
  ///   inputs  in the order of compile_expression()'s names
  double evaluate(std::span<const double> inputs) const;

  /// Whether no input is read.
  bool is_constant() const;

 private:
  friend class ExpressionCompiler;
  std::vector<ExpressionStep> steps_;
  std::size_t n_locals_ = 0;
};

/// More values than this are never on the stack, assigned names included.
constexpr std::size_t max_expression_values = 512;

/// Compiles an expression: the rows of expression_functions(), PI TWO_PI E TRUE FALSE, the inputs, and names
/// that it sets itself; names in any case. Truth is 1 or 0, and anything but 0 is true. Throws
/// ExpressionError, also for the mistake that was found when the text was read.
///   inputs  names the expression may read, in lower case; they hide constants of the same name
/// Source: Sierra decks' EVALUATE EXPRESSION; Trilinos STK expreval (the evaluator behind it).
Expression compile_expression(const DeckExpression& expression, std::span<const std::string> inputs);

}  // namespace contactsim
