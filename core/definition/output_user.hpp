// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/definition/entity_set.hpp"
#include "core/definition/expression.hpp"
#include "core/definition/output_variable.hpp"

/// Variables that the deck makes. Source: Sierra/SM 5.22, 9.4 and 10.1.
namespace contactsim {

/// How many values become one.
enum class OutputReduction : std::uint8_t {
  sum,
  maximum,
  minimum,
  average,
  absolute_maximum,
  l2_norm,
  variance
};

/// COMPUTE GLOBAL <name> AS <reduction> OF {NODAL|ELEMENT|FACE} <source>.
struct ReducedVariable {
  DeckName name;
  OutputReduction reduction = OutputReduction::sum;
  VariableLocation source_location = VariableLocation::nodal;
  VariableReference source;
};

/// COMPUTE {NODAL|ELEMENT|GLOBAL} <name> AS FUNCTION <function>.
struct FunctionVariable {
  VariableLocation location = VariableLocation::global;
  DeckName name;
  DeckName function;
};

/// COMPUTE GLOBAL <name> FROM EXPRESSION "<text>".
struct ComputedExpression {
  DeckName name;
  DeckExpression expression;
};

/// COMPUTE ELEMENT <name> AS VOLUME WEIGHTED AVERAGE OF ELEMENT <source>: over integration points.
struct VolumeAverage {
  DeckName name;
  VariableReference source;
};

/// EXTRAPOLATE ELEMENT VARIABLE <source> TO NODAL VARIABLE <name>.
struct NodalExtrapolation {
  VariableReference source;
  DeckName name;
};

using ComputedVariable =
    std::variant<ReducedVariable, FunctionVariable, ComputedExpression, VolumeAverage, NodalExtrapolation>;

/// BEGIN USER OUTPUT [name]: variables computed from others over a set; a set that names nothing is the whole
/// model.
struct UserOutput {
  DeckName name;
  EntitySet set;
  std::vector<ComputedVariable> variables;  ///< in deck order, later ones may use earlier ones
  bool is_every_step = false;               ///< COMPUTE AT EVERY STEP, otherwise as output is written
};

/// BEGIN USER VARIABLE <name>: a variable that functions and user output fill.
struct UserVariable {
  enum class Place : std::uint8_t { node, element, global };
  enum class Shape : std::uint8_t { real, integer, vector, sym_tensor, full_tensor };
  enum class GlobalOperator : std::uint8_t { sum, minimum, maximum };

  DeckName name;
  Place place = Place::node;
  Shape shape = Shape::real;
  std::int64_t length = 1;  ///< values per entity of reals and integers, >= 1
  std::vector<double> initial_values;
  GlobalOperator global_operator = GlobalOperator::sum;
  std::vector<DeckName> blocks;  ///< none: all
  bool is_in_restart = false;    ///< USE WITH RESTART
};

}  // namespace contactsim
