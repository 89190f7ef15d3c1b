// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_names.hpp"

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
        "a.i:9:13: error: unknown function 'zz'\n");
}

TEST_CASE("a condition must pick mesh parts, a direction and a value", "[parser][condition]") {
  CHECK(name_messages(
            "begin fixed rotation hinge\nend\nbegin prescribed acceleration\nend\nbegin pressure\nend\n"
            "begin traction\nend\nbegin gravity\nend\n") ==
        "a.i:1:22: error: the fixed rotation picks no part of the mesh; give it a NODE SET, "
        "SURFACE, BLOCK, ASSEMBLY or RIGID BODY line\n"
        "a.i:1:22: error: the fixed rotation has no direction; give it a COMPONENT or a "
        "DIRECTION line\n"
        "a.i:3:1: error: the prescribed acceleration picks no part of the mesh; give it a NODE "
        "SET, SURFACE, BLOCK, ASSEMBLY or RIGID BODY line\n"
        "a.i:3:1: error: the prescribed acceleration has no direction; give it a COMPONENT or a "
        "DIRECTION line\n"
        "a.i:3:1: error: the prescribed acceleration has no value; give it a FUNCTION or a READ "
        "VARIABLE line\n"
        "a.i:5:1: error: the pressure picks no part of the mesh; give it a NODE SET, SURFACE, "
        "BLOCK, ASSEMBLY or RIGID BODY line\n"
        "a.i:5:1: error: the pressure has no value; give it a FUNCTION or a READ VARIABLE line\n"
        "a.i:7:1: error: the traction picks no part of the mesh; give it a NODE SET, SURFACE, "
        "BLOCK, ASSEMBLY or RIGID BODY line\n"
        "a.i:7:1: error: the traction has no direction; give it a COMPONENT or a DIRECTION line\n"
        "a.i:7:1: error: the traction has no value; give it a FUNCTION line\n"
        "a.i:9:1: error: the gravity has no direction; give it a COMPONENT or a DIRECTION line\n");
}

TEST_CASE("a condition has one direction and one value only", "[parser][condition]") {
  CHECK(name_messages("begin prescribed moment\n block = b\n component = x\n direction = up\n function = f\n"
                      " read variable = v\n active periods = p1\n inactive periods = p2\nend\n") ==
        "a.i:1:1: error: the prescribed moment has more than one kind of direction; keep one of "
        "COMPONENT, DIRECTION and CYLINDRICAL AXIS\n"
        "a.i:1:1: error: the prescribed moment has two values; keep one of FUNCTION and READ "
        "VARIABLE\n"
        "a.i:8:21: error: ACTIVE PERIODS and INACTIVE PERIODS in one block; the active ones "
        "stand at a.i:7:19\n");
}

TEST_CASE("an initial velocity is of one kind", "[parser][condition]") {
  const auto velocity = [](const std::string& lines) {
    return name_messages("begin initial velocity\n block = b\n" + lines + "end\n");
  };
  CHECK(velocity(" component = x\n") ==
        "a.i:1:1: error: the initial velocity has no value; give it a MAGNITUDE, an ANGULAR "
        "VELOCITY or a FUNCTION line\n");
  CHECK(velocity(" component = x\n magnitude = 1\n function = f\n") ==
        "a.i:1:1: error: the initial velocity has more than one value; keep one of MAGNITUDE, "
        "ANGULAR VELOCITY and FUNCTION\n");
  CHECK(velocity(" cylindrical axis = spin\n magnitude = 1\n") ==
        "a.i:1:1: error: the initial velocity needs both or none of CYLINDRICAL AXIS and ANGULAR VELOCITY\n");
}

TEST_CASE("an initial condition names a variable, its place and one source of values",
          "[parser][condition]") {
  CHECK(name_messages("begin initial condition\n block = b\nend\n") ==
        "a.i:1:1: error: the initial condition has no variable; give it an INITIALIZE VARIABLE NAME line\n"
        "a.i:1:1: error: the initial condition does not say where its variable lives; give it a VARIABLE "
        "TYPE line\n"
        "a.i:1:1: error: the initial condition needs one of MAGNITUDE and READ VARIABLE\n");
}
