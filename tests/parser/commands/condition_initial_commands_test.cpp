// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_initial_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("an initial velocity is given by magnitude, by function or about an axis", "[parser][condition]") {
  const BoundRegion bound = bound_region(
      "begin initial velocity\n block = b\n component = z\n magnitude = -5.0\nend\n"
      "begin initial velocity\n block = b\n direction = up\n function = f\n scale factor = 2\nend\n"
      "begin initial velocity whirl\n block = b\n cylindrical axis = spin\n angular velocity = 1.0e3\nend\n");
  CHECK(bound.messages == "");
  const auto& velocities = bound.region.initial_velocities;
  REQUIRE(velocities.size() == 3);
  CHECK(velocities[0].magnitude == -5.0);
  CHECK_FALSE(velocities[0].angular_velocity);
  CHECK(velocities[1].function.function->text == "f");
  CHECK(velocities[1].function.scale_factor == 2.0);
  CHECK_FALSE(velocities[1].magnitude);
  CHECK(velocities[2].angular_velocity == 1000.0);
  CHECK(velocities[2].direction.cylindrical_axis->text == "spin");
}

TEST_CASE("an initial condition gives a variable its values", "[parser][condition]") {
  const BoundRegion bound = bound_region(
      "begin initial condition\n include all blocks\n initialize variable name = velocity\n variable type = "
      "node\n"
      " magnitude = 1.0, 2.0, 3.0\nend\n"
      "begin initial condition\n block = b\n initialize variable name = stress\n variable type = element\n"
      " read variable = s\n time = last\n scale factor = 0.5\nend\n");
  CHECK(bound.messages == "");
  const auto& conditions = bound.region.initial_conditions;
  REQUIRE(conditions.size() == 2);
  CHECK(conditions[0].variable->text == "velocity");
  CHECK(conditions[0].type == VariableType::node);
  CHECK(conditions[0].magnitude == std::vector<double>{1.0, 2.0, 3.0});
  CHECK(conditions[0].scale_factor == 1.0);
  CHECK(conditions[1].type == VariableType::element);
  CHECK(conditions[1].magnitude.empty());
  CHECK(conditions[1].mesh_variable.variable->text == "s");
  CHECK(conditions[1].scale_factor == 0.5);
}
