// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/function_commands.hpp"

#include <fmt/format.h>

#include "parser/commands/block_rows.hpp"

namespace contactsim {

namespace {

const Choices& type_words() {
  static const Choices words({"piecewise linear", "piecewise constant", "constant", "analytic",
                              "piecewise analytic", "piecewise multivariate", "multicolumn piecewise linear",
                              "xtable", "polynomial", "haversine spike"});
  return words;
}

const Choices& source_words() {
  static const Choices words({"global", "nodal", "nodal vector", "nodal tensor", "nodal sym tensor",
                              "element", "element vector", "element tensor", "element sym tensor", "face"});
  return words;
}

void read_function_type(Arguments& arguments, FunctionDefinition& function) {
  function.type_location = arguments.location();
  function.type = static_cast<FunctionType>(arguments.choice(type_words()));
}

/// Whether two lines are one point of two numbers.
bool is_same_point(const FunctionValue& a, const FunctionValue& b) {
  return a.abscissa == b.abscissa && a.ordinate == b.ordinate && a.expression.empty() &&
         b.expression.empty() && a.further.empty() && b.further.empty();
}

void read_value(Arguments& arguments, FunctionDefinition& function) {
  FunctionValue value;
  const Word start = arguments.peek();
  value.location = arguments.location();
  const double first = arguments.real();
  if (arguments.at_end()) {
    value.ordinate = first;
  } else {
    value.abscissa = first;
    if (arguments.peek().kind == WordKind::quoted) {
      value.expression = arguments.text();
    } else {
      value.ordinate = arguments.real();
    }
    if (!arguments.at_end()) value.further = arguments.reals();
  }
  const bool is_repeated = !function.values.empty() && is_same_point(function.values.back(), value);
  if (is_repeated) {
    arguments.warn("function-repeat", start, "a point of the function is repeated; the first one is taken",
                   "write each point once");
    return;
  }
  function.values.push_back(std::move(value));
}

void read_function_input(Arguments& arguments, FunctionDefinition& function) {
  ExpressionVariable variable;
  variable.name = arguments.name();
  arguments.skip_separator();
  variable.source = static_cast<ExpressionSource>(arguments.choice(source_words()));
  variable.variable = arguments.name();
  function.variables.push_back(std::move(variable));
}

const Table<FunctionDefinition>& values_table() {
  static const Table<FunctionDefinition> table({
      numbers<FunctionDefinition>("<abscissa> <ordinate>, or <value>", read_value,
                                  "One point of the function, or its value [abscissa, ordinate]"),
  });
  return table;
}

}  // namespace

const Table<FunctionDefinition>& function_table() {
  using F = FunctionDefinition;
  static const Table<F> table({
      row<F>("type", "= " + syntax_of_choice(type_words()), read_function_type, "How the function is given",
             "none")
          .once()
          .required(),
      block_into("values", Naming::none, values_table, "The points of a function, one a line"),
      row("abscissa", read::rest_of_line, &F::abscissa_label, "What the abscissa is, for people"),
      row("ordinate", read::rest_of_line, &F::ordinate_label, "What the ordinate is, for people"),
      row("x scale", read::real, &F::x_scale, "Factor of (abscissa + offset) [1]")
          .or_spelled("abscissa scale"),
      row("x offset", read::real, &F::x_offset, "Added to the abscissa before scaling [abscissa]")
          .or_spelled("abscissa offset"),
      row("y scale", read::real, &F::y_scale, "Factor of (ordinate + offset) [1]")
          .or_spelled("ordinate scale"),
      row("y offset", read::real, &F::y_offset, "Added to the ordinate before scaling [ordinate]")
          .or_spelled("ordinate offset"),
      row("at discontinuity evaluate to", choice_of<DiscontinuitySide>({"left", "right"}),
          &F::at_discontinuity, "Side whose value a piecewise function takes at a jump"),
      row<F>(
          "evaluate expression", "= \"<expression>\"",
          [](Arguments& arguments, F& function) { function.expression = read_expression(arguments); },
          "The function's value, C-like, of x or of the expression variables", "none")
          .once(),
      row<F>("expression variable", ": <name> = " + syntax_of_choice(source_words()) + " <variable>",
             read_function_input, "A variable of the expression and what it reads", "none"),
      refused<F>("differentiate expression", "= \"<expression>\"",
                 "give the derivative as a function of its own"),
      ignored<F>("evaluate from", "<a> TO <b> BY <dx>", "the expression is evaluated at every point"),
      refused<F>("data file", "= <file> [X FROM COLUMN <i> Y FROM COLUMN <j>]",
                 "put the values into a VALUES block, or name the file by INCLUDEFILE inside it"),
      ignored<F>("column titles", "<name> ...", "titles are for people"),
      refused<F>("scale by", "<factor>", "use Y SCALE"),
      ignored<F>("debug", "= {ON|OFF}", "functions print nothing"),
  });
  return table;
}

}  // namespace contactsim
