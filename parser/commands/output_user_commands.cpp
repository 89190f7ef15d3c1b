// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_user_commands.hpp"

#include "parser/commands/entity_set_commands.hpp"
#include "parser/commands/row_lists.hpp"
#include "parser/commands/variable_readers.hpp"

namespace contactsim {

namespace {

/// <reduction> OF {NODAL|ELEMENT|FACE} <variable>, after AS.
void read_reduction(Arguments& arguments, const DeckName& name, UserOutput& output) {
  using R = OutputReduction;
  static const Choices words({"sum", "max", "min", "average", "max absolute value", "l2norm", "variance"});
  static constexpr R reductions[] = {R::sum,     R::maximum, R::minimum, R::average, R::absolute_maximum,
                                     R::l2_norm, R::variance};
  ReducedVariable variable{name, reductions[arguments.choice(words)], {}, {}};
  arguments.expect("of");
  variable.source_location = read_location(arguments);
  variable.source = read_variable(arguments);
  output.variables.emplace_back(std::move(variable));
}

/// AS FUNCTION <function>, if that is next.
bool read_function(Arguments& arguments, VariableLocation location, const DeckName& name,
                   UserOutput& output) {
  if (!arguments.accept("function")) return false;
  output.variables.emplace_back(FunctionVariable{location, name, arguments.reference(NameKind::function)});
  return true;
}

void read_global(Arguments& arguments, UserOutput& output) {
  const DeckName name = arguments.name();
  if (arguments.accept("from")) {
    arguments.expect("expression");
    arguments.skip_separator();
    output.variables.emplace_back(ComputedExpression{name, read_expression(arguments)});
    return;
  }
  arguments.expect("as");
  if (!read_function(arguments, VariableLocation::global, name, output))
    read_reduction(arguments, name, output);
}

void read_nodal(Arguments& arguments, UserOutput& output) {
  const DeckName name = arguments.name();
  arguments.expect("as");
  if (!read_function(arguments, VariableLocation::nodal, name, output)) arguments.expect("function");
}

void read_element(Arguments& arguments, UserOutput& output) {
  static const Choices averages(
      {"volume weighted average of element", "nonlocal average of element", "nonlocal average"});
  const DeckName name = arguments.name();
  arguments.expect("as");
  if (read_function(arguments, VariableLocation::element, name, output)) return;
  if (arguments.at_end())
    arguments.fail_here("expected FUNCTION or VOLUME WEIGHTED AVERAGE OF ELEMENT after 'as'");
  const Word& average = arguments.peek();
  if (arguments.choice(averages) != 0) arguments.refuse(average, "averages over neighbours are not computed");
  output.variables.emplace_back(VolumeAverage{name, read_variable(arguments)});
}

void read_extrapolation(Arguments& arguments, UserOutput& output) {
  NodalExtrapolation extrapolation{read_variable(arguments), {}};
  arguments.expect("to");
  arguments.expect("nodal");
  arguments.expect("variable");
  extrapolation.name = arguments.name();
  output.variables.emplace_back(std::move(extrapolation));
}

const Table<UserOutput>& user_output_table() {
  using U = UserOutput;
  static const Table<U> table(joined<U>({
      lift_all(entity_set_rows(), &U::set),
      {
          flag("compute at every step", &U::is_every_step,
               "Computes in every step, not as output is written alone"),
          row<U>(
              "compute at every time", "", [](Arguments&, U&) {}, "Computes as output is written", "on"),
          row<U>(
              "compute global",
              "<name> AS {{SUM|MAX|MIN|AVERAGE|MAX ABSOLUTE VALUE|L2NORM|VARIANCE} OF {NODAL|ELEMENT|FACE} "
              "<variable>|FUNCTION <function>}, or <name> FROM EXPRESSION \"...\"",
              read_global, "A value of the set, in its source's dimension", "none")
              .references(NameKind::function),
          row<U>("compute nodal", "<name> AS FUNCTION <function>", read_nodal, "A value at nodes", "none")
              .references(NameKind::function),
          row<U>("compute element",
                 "<name> AS {FUNCTION <function>|VOLUME WEIGHTED AVERAGE OF ELEMENT <variable>}",
                 read_element, "A value in elements", "none")
              .references(NameKind::function),
          row<U>("extrapolate element variable", "<variable> TO NODAL VARIABLE <name>", read_extrapolation,
                 "Carries element values to nodes", "none"),
      },
  }));
  return table;
}

/// [REAL|INTEGER] [VECTOR|SYM_TENSOR|FULL_TENSOR|LENGTH = <n>], after NODE, ELEMENT or GLOBAL.
void read_shape(Arguments& arguments, UserVariable& variable) {
  using Shape = UserVariable::Shape;
  if (arguments.accept("integer")) {
    variable.shape = Shape::integer;
  } else {
    arguments.accept("real");
  }
  if (arguments.accept("length")) {
    arguments.skip_separator();
    variable.length = arguments.positive_integer();
    return;
  }
  if (arguments.at_end()) return;
  static const Choices shapes({"vector", "sym tensor", "full tensor"});
  static constexpr Shape meanings[] = {Shape::vector, Shape::sym_tensor, Shape::full_tensor};
  variable.shape = meanings[arguments.choice(shapes)];
}

void read_variable_type(Arguments& arguments, UserVariable& variable) {
  using P = UserVariable::Place;
  static const Choices places({"node", "nodal", "element", "global"});
  static constexpr P meanings[] = {P::node, P::node, P::element, P::global};
  variable.place = meanings[arguments.choice(places)];
  read_shape(arguments, variable);
}

const Table<UserVariable>& user_variable_table() {
  using U = UserVariable;
  static const auto global_operator = choice_of<U::GlobalOperator>({"sum", "min", "max"});
  static const Table<U> table({
      row<U>("type", "= {NODE|ELEMENT|GLOBAL} {{REAL|INTEGER} LENGTH = <n>|VECTOR|SYM_TENSOR|FULL_TENSOR}",
             read_variable_type, "Where the variable lives and how many values it has [1]",
             "NODE REAL LENGTH = 1"),
      row("initial value", read::reals, &U::initial_values,
          "Values at the start, in the variable's dimension", "0"),
      row("global operator", global_operator, &U::global_operator,
          "How values of several processors become one"),
      row("block", read::names_of(NameKind::block), &U::blocks, "Blocks that have the variable", "all"),
      flag("use with restart", &U::is_in_restart, "Writes the variable to restart files"),
  });
  return table;
}

}  // namespace

std::vector<Row<Region>> user_output_rows() {
  using R = Region;
  return {
      block<R, UserOutput>("user output", Naming::optional, user_output_table, &R::user_outputs,
                           "Variables computed from others"),
      block<R, UserVariable>("user variable", Naming::required, user_variable_table, &R::user_variables,
                             "A variable that functions and user output fill")
          .defines(NameKind::user_variable),
  };
}

}  // namespace contactsim
