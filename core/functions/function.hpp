// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/function.hpp"
#include "core/functions/expression.hpp"
#include "core/functions/piecewise.hpp"

namespace contactsim {

/// One number that an analytic function reads besides, or instead of, an abscissa.
struct FunctionInput {
  std::string name;  ///< in the expression, lower case: v, or v_x of a vector
  ExpressionSource source = ExpressionSource::global;
  DeckName variable;           ///< as the deck writes it, such as coordinates(x)
  std::string_view component;  ///< x or xy of a vector or tensor; "" of a scalar
};

/// A function of the deck, scaled and ready to evaluate. Evaluating allocates nothing and changes nothing,
/// so threads may share it. The value is not finite where an expression has none: who asks must check.
class Function {
 public:
  /// The function that is `value` everywhere.
  explicit Function(double value) : form_(value) {}

  /// The value at an abscissa, time in most commands [ordinate]. Precondition: inputs() is empty.
  double evaluate(double abscissa) const;

  /// The value of the inputs, one number each in the order of inputs(), or the abscissa if there are none.
  double evaluate(std::span<const double> inputs) const;

  /// What the EXPRESSION VARIABLE lines make the function read; empty for a function of its abscissa.
  std::span<const FunctionInput> inputs() const { return inputs_; }

  /// Whether the value is the same everywhere.
  bool is_constant() const;

 private:
  struct Analytic {
    Expression expression;
    double y_scale = 1.0, y_offset = 0.0;
  };
  using Form = std::variant<double, PiecewiseLinear, PiecewiseConstant, Analytic>;
  explicit Function(Form form) : form_(std::move(form)) {}
  friend class FunctionMaker;

  Form form_;
  std::vector<FunctionInput> inputs_;
};

/// Checks and compiles a definition; nothing when an error was added. Errors: no type, or one that is not
/// supported; values that are missing or not pairs; abscissae that decrease, or stand twice where that is no
/// jump; an X SCALE that is not positive, or any X SCALE or X OFFSET of an analytic function (it has two
/// readings); a scaled value that is not finite; what is wrong in an expression, at its character.
std::optional<Function> make_function(const FunctionDefinition& definition, Diagnostics& diagnostics);

/// The abscissa, as the deck writes it, at which a table has two values; nothing without one. Laws whose
/// slope counts refuse it.
std::optional<double> find_jump(const FunctionDefinition& definition);

/// The function that a command names: one of the definitions, or the built-in sierra_constant_function_one.
/// Nothing when an error was added, at the name if it is unknown.
std::optional<Function> make_named_function(const DeckName& name,
                                            std::span<const FunctionDefinition> definitions,
                                            Diagnostics& diagnostics);

}  // namespace contactsim
