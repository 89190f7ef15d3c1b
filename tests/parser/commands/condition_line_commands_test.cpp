// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_line_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

std::string components(const DirectionChoice& choice) {
  std::string letters;
  for (std::size_t i = 0; i < 3; ++i) {
    if (choice.components[i]) letters += "xyz"[i];
  }
  return letters;
}

DirectionChoice direction_of(const std::string& line) {
  const BoundRegion bound = bound_region("begin fixed displacement\n" + line + "\nend\n");
  CHECK(bound.messages == "");
  return bound.region.fixed_conditions.at(0).direction;
}

}  // namespace

TEST_CASE("components are letters with blanks, slashes or nothing between them", "[parser][condition]") {
  CHECK(components(direction_of("component = X")) == "x");
  CHECK(components(direction_of("component = x z")) == "xz");
  CHECK(components(direction_of("components = X Y Z")) == "xyz");
  CHECK(components(direction_of("components = X/Y/Z")) == "xyz");
  CHECK(components(direction_of("components = x / y")) == "xy");
  CHECK(components(direction_of("components = y, z")) == "yz");
  CHECK(components(direction_of("components xy")) == "xy");
  CHECK(bound_region("begin fixed displacement\ncomponent = w\ncomponents\nend\n").messages ==
        "a.i:2:13: error: expected X, Y or Z for 'component', found 'w'\n"
        "a.i:3:1: error: expected X, Y or Z after 'components', found the end of the line\n");
}

TEST_CASE("letters of components may be repeated, and none may be another", "[parser][condition]") {
  CHECK(components(direction_of("components = x X x")) == "x");
  CHECK(components(direction_of("components = zyx")) == "xyz");
  CHECK(bound_region("begin fixed displacement\ncomponents = x y q\nend\n").messages ==
        "a.i:2:18: error: expected X, Y or Z for 'components', found 'q'\n");
}

TEST_CASE("a variable of the mesh is read as the run goes, or at a stored time", "[parser][condition]") {
  const auto variable_of = [](const std::string& lines) {
    const BoundRegion bound = bound_region(
        "begin prescribed force\nnode set = n\ncomponent = x\nread variable = v\n" + lines + "end\n");
    CHECK(bound.messages == "");
    return bound.region.nodal_loads.at(0).variable;
  };
  CHECK(variable_of("").time == MeshVariable::Time::run_time);
  CHECK(variable_of("").variable->text == "v");
  CHECK_FALSE(variable_of("").object);
  CHECK(variable_of("time = FIRST\n").time == MeshVariable::Time::first);
  CHECK(variable_of("time = last\n").time == MeshVariable::Time::last);
  CHECK(variable_of("time = -2.5\n").time == MeshVariable::Time::given);
  CHECK(variable_of("time = -2.5\n").given_time == -2.5);
  CHECK(variable_of("object type = face\n").object == MeshVariable::Object::face);
}

TEST_CASE("lines that hand a condition to a subroutine are refused, all but how to debug it",
          "[parser][condition]") {
  const auto said = [](const std::string& line) {
    return bound_region("begin prescribed force\n" + line + "\nend\n").messages;
  };
  for (const char* line : {"node set subroutine = s", "nodeset subroutine = s", "surface subroutine = s",
                           "element block subroutine = s", "subroutine real parameter: a = 1",
                           "subroutine integer parameter: a = 1", "subroutine string parameter: a = b"}) {
    INFO(line);
    CHECK(said(line).starts_with("a.i:2:1: error: "));
    CHECK(said(line).find("user subroutines cannot be run") != std::string::npos);
  }
  CHECK(said("subroutine debugging on").starts_with("a.i:2:1: warning: "));
}
