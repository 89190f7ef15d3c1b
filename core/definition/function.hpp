// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/names.hpp"
#include "core/definition/expression.hpp"

namespace contactsim {

enum class FunctionType : std::uint8_t {
  piecewise_linear,
  piecewise_constant,
  constant,
  analytic,
  piecewise_analytic,
  piecewise_multivariate,
  multicolumn_piecewise_linear,
  xtable,
  polynomial,
  haversine_spike
};

/// One line of a VALUES block. A CONSTANT function has one line with one number, its value: the abscissa is
/// NaN then.
struct FunctionValue {
  DeckLocation location;
  double abscissa = std::numeric_limits<double>::quiet_NaN();  ///< as written, before X SCALE and X OFFSET
  double ordinate = std::numeric_limits<double>::quiet_NaN();  ///< as written, before Y SCALE and Y OFFSET
  std::vector<double> further;  ///< the numbers after the second, of tables of several columns
  std::string expression;       ///< in place of the ordinate, of PIECEWISE ANALYTIC
};

/// What a variable of an analytic function reads.
enum class ExpressionSource : std::uint8_t {
  global,
  nodal,
  nodal_vector,
  nodal_tensor,
  nodal_sym_tensor,
  element,
  element_vector,
  element_tensor,
  element_sym_tensor,
  face
};

/// EXPRESSION VARIABLE: <name> = <source> <variable>.
struct ExpressionVariable {
  DeckName name;
  ExpressionSource source = ExpressionSource::global;
  DeckName variable;  ///< such as coordinates(x)
};

enum class DiscontinuitySide : std::uint8_t { left, right };

/// BEGIN FUNCTION <name>. Both coordinates are transformed alike: scale * (value + offset).
/// Source: Sierra/SM 5.22 and Aria 5.24, DEFINITION FOR FUNCTION.
struct FunctionDefinition {
  DeckName name;
  std::optional<FunctionType> type;
  DeckLocation type_location;
  std::vector<FunctionValue> values;           ///< in deck order
  double x_scale = 1.0, x_offset = 0.0;        ///< of the abscissa: scale [1], offset [abscissa]
  double y_scale = 1.0, y_offset = 0.0;        ///< of the ordinate: scale [1], offset [ordinate]
  std::string abscissa_label, ordinate_label;  ///< for people only
  DiscontinuitySide at_discontinuity = DiscontinuitySide::right;
  std::optional<DeckExpression> expression;  ///< of x when there are no variables
  std::vector<ExpressionVariable> variables;
};

/// The name of the function that is 1 everywhere and needs no definition.
inline constexpr const char* constant_one_function = "sierra_constant_function_one";

}  // namespace contactsim
