// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/condition_load_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a pressure is bound with its defaults", "[parser][condition]") {
  const BoundRegion bound = bound_region("begin pressure\n surface = s\n function = f\nend\n");
  CHECK(bound.messages == "");
  const Pressure& pressure = bound.region.pressures.at(0);
  CHECK(joined_names(pressure.set.side_sets) == "s");
  CHECK(pressure.function.function->text == "f");
  CHECK(pressure.function.scale_factor == 1.0);
  CHECK(pressure.velocity_damping_coefficient == 0.0);
  CHECK(pressure.masking == Pressure::Masking::off);
  CHECK_FALSE(pressure.force_output_name);
}

TEST_CASE("a pressure takes all of its lines", "[parser][condition]") {
  const BoundRegion bound = bound_region(
      "begin pressure blow\n sideset = s\n read variable = p\n object type = node\n time = first\n scale "
      "factor 2\n"
      " velocity damping coefficient = 0.5\n masking method = contact\n"
      " external force contribution output name = f_blow\n active periods = p1\nend\n");
  CHECK(bound.messages == "");
  const Pressure& pressure = bound.region.pressures.at(0);
  CHECK(pressure.name.text == "blow");
  CHECK(pressure.variable.variable->text == "p");
  CHECK(pressure.variable.object == MeshVariable::Object::node);
  CHECK(pressure.function.scale_factor == 2.0);
  CHECK(pressure.velocity_damping_coefficient == 0.5);
  CHECK(pressure.masking == Pressure::Masking::contact);
  CHECK(pressure.force_output_name == "f_blow");
  CHECK(joined_names(pressure.periods.active) == "p1");
}

TEST_CASE("forces, moments and tractions have a direction and a function", "[parser][condition]") {
  const std::string lines = " sideset = s\n direction = up\n function = f\n scale factor = 3\nend\n";
  const BoundRegion bound = bound_region("begin prescribed force\n" + lines + "begin prescribed moment\n" +
                                         lines + "begin traction\n" + lines);
  CHECK(bound.messages == "");
  REQUIRE(bound.region.nodal_loads.size() == 2);
  CHECK_FALSE(bound.region.nodal_loads[0].is_moment);
  CHECK(bound.region.nodal_loads[1].is_moment);
  CHECK(bound.region.nodal_loads[1].function.scale_factor == 3.0);
  CHECK(bound.region.tractions.at(0).direction.direction->text == "up");
}

TEST_CASE("gravity needs no set and no function", "[parser][condition]") {
  const BoundRegion bound = bound_region(
      "begin gravity\n component = z\n gravitational constant = 9.81\n scale factor = -1\nend\n"
      "begin gravity side\n include all blocks\n direction = up\n function = f\nend\n");
  CHECK(bound.messages == "");
  REQUIRE(bound.region.gravities.size() == 2);
  CHECK(bound.region.gravities[0].gravitational_constant == 9.81);
  CHECK(bound.region.gravities[0].function.scale_factor == -1.0);
  CHECK_FALSE(bound.region.gravities[0].function.function);
  CHECK(bound.region.gravities[1].gravitational_constant == 1.0);
  CHECK(bound.region.gravities[1].function.function->text == "f");
}
