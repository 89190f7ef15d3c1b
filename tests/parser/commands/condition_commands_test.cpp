// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a fixed displacement and a fixed rotation are bound with their names", "[parser][condition]") {
  const BoundRegion bound = bound_region(
      "begin fixed displacement base\n node set = n\n component = z\n active periods = p1 p2\nend\n"
      "begin fixed rotation\n block = b\n direction = up\n inactive periods = p3\nend\n");
  CHECK(bound.messages == "");
  REQUIRE(bound.region.fixed_conditions.size() == 2);
  const FixedCondition& displacement = bound.region.fixed_conditions[0];
  CHECK(displacement.name.text == "base");
  CHECK_FALSE(displacement.is_rotation);
  CHECK(joined_names(displacement.periods.active) == "p1 p2");
  const FixedCondition& rotation = bound.region.fixed_conditions[1];
  CHECK(rotation.name.text == "");
  CHECK(to_string(rotation.name.location) == "a.i:6:1");
  CHECK(rotation.is_rotation);
  CHECK(rotation.direction.direction->text == "up");
  CHECK(joined_names(rotation.periods.inactive) == "p3");
}

TEST_CASE("each prescribed quantity has its block", "[parser][condition]") {
  const auto [phrase, quantity] = GENERATE(table<std::string, PrescribedQuantity>({
      {"prescribed displacement", PrescribedQuantity::displacement},
      {"prescribed velocity", PrescribedQuantity::velocity},
      {"prescribed acceleration", PrescribedQuantity::acceleration},
      {"prescribed rotation", PrescribedQuantity::rotation},
      {"prescribed rotational velocity", PrescribedQuantity::rotational_velocity},
  }));
  const BoundRegion bound = bound_region("begin " + phrase +
                                         " move\n rigid body = rb\n cylindrical axis = spin\n function = f\n"
                                         " scale factor = -2.5\nend " +
                                         phrase + "\n");
  CHECK(bound.messages == "");
  const PrescribedCondition& condition = bound.region.prescribed_conditions.at(0);
  CHECK(condition.name.text == "move");
  CHECK(condition.quantity == quantity);
  CHECK(condition.direction.cylindrical_axis->text == "spin");
  CHECK(condition.function.function->text == "f");
  CHECK(condition.function.scale_factor == -2.5);
  CHECK_FALSE(condition.variable.variable);
}

TEST_CASE("values can be read from the mesh", "[parser][condition]") {
  const auto variable_of = [](const std::string& lines) {
    const BoundRegion bound =
        bound_region("begin prescribed displacement\nread variable = v\n" + lines + "end\n");
    CHECK(bound.messages == "");
    return bound.region.prescribed_conditions.at(0).variable;
  };
  CHECK(variable_of("").variable->text == "v");
  CHECK(variable_of("").time == MeshVariable::Time::run_time);
  CHECK(variable_of("time = FIRST\n").time == MeshVariable::Time::first);
  CHECK(variable_of("time last\n").time == MeshVariable::Time::last);
  CHECK(variable_of("time = 2.0e-3\n").time == MeshVariable::Time::given);
  CHECK(variable_of("time = 2.0e-3\n").given_time == 2.0e-3);
  CHECK(variable_of("object type = face\n").object == MeshVariable::Object::face);
  CHECK_FALSE(variable_of("").object);
}

TEST_CASE("user subroutines and copied variables are refused", "[parser][condition]") {
  const std::string deck =
      "begin prescribed force\n node set subroutine = s\n subroutine real parameter: a = 1\n"
      " copy variable = v from model m\nend\n";
  CHECK(bound_region(deck).messages ==
        "a.i:2:2: error: 'node set subroutine' is not supported and would change the answer; "
        "user subroutines cannot be run; an analytic FUNCTION may say the same\n"
        "a.i:3:2: error: 'subroutine real parameter' is not supported and would change the "
        "answer; user subroutines cannot be run; an analytic FUNCTION may say the same\n"
        "a.i:4:2: error: 'copy variable' is not supported and would change the answer; there is "
        "one model only; READ VARIABLE reads its file\n");
  CHECK(bound_region(deck, true).messages.find("error") == std::string::npos);
}

TEST_CASE("temperatures are ignored, loads that are not modelled are refused", "[parser][condition]") {
  CHECK(bound_region("begin initial temperature\n magnitude = 300\nend\n").messages ==
        "a.i:1:7: warning: block 'initial temperature' has no effect here; temperatures act "
        "through thermal strains only, which are not supported [deck-ignored]\n");
  CHECK(bound_region("begin silent boundary\n surface = s\nend\n").messages ==
        "a.i:1:7: error: block 'silent boundary' is not supported and would change the answer; "
        "boundaries reflect waves\n");
}
