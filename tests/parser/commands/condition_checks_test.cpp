// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a whole condition of each kind is fine", "[parser][condition]") {
  CHECK(name_messages(
            "begin fixed displacement\n node set = n\n component = x\n active periods = P1\nend\n"
            "begin prescribed velocity\n block = b\n direction = UP\n function = F\nend\n"
            "begin prescribed rotation\n rigid body = RB\n cylindrical axis = spin\n function = g\nend\n"
            "begin prescribed force\n node set = n\n component = y\n read variable = v\nend\n"
            "begin pressure\n surface = s\n function = f\n inactive periods = p2\nend\n"
            "begin traction\n surface = s\n component = x\n function = f\nend\n"
            "begin gravity\n component = z\nend\n"
            "begin initial velocity\n block = b\n cylindrical axis = spin\n angular velocity = 1\nend\n"
            "begin initial condition\n initialize variable name = v\n variable type = global\n"
            " magnitude = 1\nend\n") == "");
}

TEST_CASE("names that a condition uses must be defined", "[parser][condition]") {
  CHECK(name_messages(
            "begin prescribed displacement\n rigid body = rbb\n cylindrical axis = spinn\n function = h\n"
            " active periods = p1 p3\nend\n"
            "begin gravity\n direction = upp\n function = zz\nend\n") ==
        "a.i:2:15: error: unknown rigid body 'rbb'; did you mean 'rb'?\n"
        "a.i:3:21: error: unknown axis 'spinn'; did you mean 'spin'?\n"
        "a.i:4:13: error: unknown function 'h'; did you mean 'f'?\n"
        "a.i:5:22: error: unknown time stepping block 'p3'; did you mean 'p1'?\n"
        "a.i:8:14: error: unknown direction 'upp'; did you mean 'up'?\n"
        "a.i:9:13: error: unknown function 'zz'; the deck has f, g\n");
}

TEST_CASE("a condition must pick mesh parts, a direction and a value", "[parser][condition]") {
  const std::string parts =
      " picks no part of the mesh; give it INCLUDE ALL BLOCKS, NODE SET, SURFACE, BLOCK, ASSEMBLY, RIGID "
      "BODY, "
      "NODE or ELEMENT\n";
  const std::string value = " has no value; give it FUNCTION or READ VARIABLE\n";
  CHECK(name_messages(
            "begin fixed rotation hinge\nend\nbegin prescribed acceleration\nend\nbegin pressure\nend\n"
            "begin traction\nend\nbegin gravity\nend\n") ==
        "a.i:1:22: error: the fixed rotation 'hinge'" + parts +
            "a.i:1:22: error: the fixed rotation 'hinge' has no direction; give it COMPONENT or DIRECTION\n"
            "a.i:3:1: error: the prescribed acceleration" +
            parts +
            "a.i:3:1: error: the prescribed acceleration has no direction; give it COMPONENT, DIRECTION or "
            "CYLINDRICAL AXIS\n"
            "a.i:3:1: error: the prescribed acceleration" +
            value + "a.i:5:1: error: the pressure" + parts + "a.i:5:1: error: the pressure" + value +
            "a.i:7:1: error: the traction" + parts +
            "a.i:7:1: error: the traction has no direction; give it COMPONENT or DIRECTION\n"
            "a.i:7:1: error: the traction has no FUNCTION; add FUNCTION = <function>\n"
            "a.i:9:1: error: the gravity has no direction; give it COMPONENT or DIRECTION\n");
}

TEST_CASE("a condition has one direction and one value only", "[parser][condition]") {
  CHECK(
      name_messages("begin prescribed moment\n block = b\n component = x\n direction = up\n function = f\n"
                    " read variable = v\n active periods = p1\n inactive periods = p2\nend\n") ==
      "a.i:4:2: error: the prescribed moment has more than one kind of direction; keep one of COMPONENT and "
      "DIRECTION; the first stands at a.i:3:2\n"
      "a.i:6:2: error: the prescribed moment has more than one value; keep one of FUNCTION and READ "
      "VARIABLE; the first stands at a.i:5:2\n"
      "a.i:8:2: error: the prescribed moment has both active and inactive periods; keep one of ACTIVE "
      "PERIODS and INACTIVE PERIODS; the first stands at a.i:7:2\n");
}

TEST_CASE("an initial velocity is of one kind", "[parser][condition]") {
  const auto velocity = [](const std::string& lines) {
    return name_messages("begin initial velocity\n block = b\n" + lines + "end\n");
  };
  CHECK(
      velocity(" component = x\n") ==
      "a.i:1:1: error: the initial velocity has no value; give it MAGNITUDE, ANGULAR VELOCITY or FUNCTION\n");
  CHECK(
      velocity(" component = x\n magnitude = 1\n function = f\n") ==
      "a.i:5:2: error: the initial velocity has more than one value; keep one of MAGNITUDE, ANGULAR VELOCITY "
      "and FUNCTION; the first stands at a.i:4:2\n");
  CHECK(velocity(" cylindrical axis = spin\n magnitude = 1\n") ==
        "a.i:1:1: error: the initial velocity needs both or none of CYLINDRICAL AXIS and ANGULAR VELOCITY\n");
}

TEST_CASE("an initial condition names a variable, its place and one source of values",
          "[parser][condition]") {
  CHECK(
      name_messages("begin initial condition\n block = b\nend\n") ==
      "a.i:1:1: error: the initial condition has no INITIALIZE VARIABLE NAME; add INITIALIZE VARIABLE NAME = "
      "<name>\n"
      "a.i:1:1: error: the initial condition has no VARIABLE TYPE; add VARIABLE TYPE = "
      "{node|edge|face|element|global}\n"
      "a.i:1:1: error: the initial condition has no value; give it MAGNITUDE or READ VARIABLE\n");
}
