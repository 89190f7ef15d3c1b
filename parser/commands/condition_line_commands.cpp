// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_line_commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parser/text/word_grammar.hpp"

namespace contactsim {

namespace {

const Choice one_direction{"has no direction", "has more than one kind of direction"};

/// Letters, in one word or several, with slashes between them if one likes: "X Y", "x/y/z".
void read_components(Arguments& arguments, DirectionChoice& choice) {
  do {
    const Word& letters = arguments.word("X, Y or Z");
    const auto axes = find_axes(letters.text);
    if (!axes) {
      arguments.fail(letters,
                     fmt::format("expected X, Y or Z for '{}', found '{}'", arguments.what(), letters.text));
    }
    for (std::size_t i = 0; i < axes->size(); ++i) {
      if ((*axes)[i]) choice.components[i] = true;
    }
  } while (!arguments.at_end());
}

void read_stored_time(Arguments& arguments, MeshVariable& variable) {
  if (arguments.accept("first")) {
    variable.time = MeshVariable::Time::first;
  } else if (arguments.accept("last")) {
    variable.time = MeshVariable::Time::last;
  } else {
    variable.given_time = arguments.real();
    variable.time = MeshVariable::Time::given;
  }
}

}  // namespace

std::vector<Row<DirectionChoice>> direction_rows() {
  using D = DirectionChoice;
  return {
      row<D>("component", "= {X|Y|Z} ...", read_components, "Acts along these global axes, on each alike",
             "none")
          .or_spelled("components")
          .one_of(one_direction),
      row("direction", read::name_of(NameKind::direction), &D::direction,
          "Acts along a direction of DEFINE DIRECTION")
          .one_of(one_direction),
  };
}

std::vector<Row<DirectionChoice>> direction_or_axis_rows() {
  std::vector<Row<DirectionChoice>> rows = direction_rows();
  rows.push_back(row("cylindrical axis", read::name_of(NameKind::axis), &DirectionChoice::cylindrical_axis,
                     "Turns about an axis of DEFINE AXIS: values are angles in radians [1] for lengths")
                     .one_of(one_direction));
  return rows;
}

std::vector<Row<ActivePeriods>> period_rows() {
  using P = ActivePeriods;
  const auto periods = read::names_of(NameKind::time_stepping_block);
  return one_of<P>(
      {"", "has both active and inactive periods"},
      {row("active periods", periods, &P::active, "Acts in these time stepping blocks only", "all"),
       row("inactive periods", periods, &P::inactive, "Acts in all time stepping blocks but these")});
}

std::vector<Row<MeshVariable>> mesh_variable_rows() {
  using V = MeshVariable;
  static const auto object = choice_of<V::Object>({"node", "face"});
  return {
      row("read variable", read::name, &V::variable, "Variable of the mesh file that gives the values")
          .one_of(one_value),
      row<V>("time", "= {<t>|FIRST|LAST}", read_stored_time, "Stored time [time] that is read",
             "as the run goes"),
      row("object type", object, &V::object, "Where the variable that is read lives", "as the block says"),
      refused<V>("copy variable", "= <name> [FROM MODEL <model>]",
                 "There is one model only; READ VARIABLE reads its file"),
  };
}

std::vector<Row<ScaledFunction>> scaled_function_rows(const std::string& prefix, const std::string& meaning,
                                                      const Choice& choice) {
  const std::string start = prefix.empty() ? "" : prefix + " ";
  return {
      row(start + "function", read::name_of(NameKind::function), &ScaledFunction::function,
          "Function " + meaning)
          .one_of(choice),
      row(start + "scale factor", read::real, &ScaledFunction::scale_factor, "Multiplies the function [1]"),
  };
}

}  // namespace contactsim
