// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/friction_commands.hpp"

#include <cmath>

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// The law of a single friction model.
template <class Law>
Law law_of(const std::string& block) {
  const BoundContact bound = bound_contact(block + "end\n");
  CHECK(bound.messages == "");
  REQUIRE(bound.contact.friction_models.size() == 1);
  CHECK(bound.contact.friction_models[0].name.text == "m");
  return std::get<Law>(bound.contact.friction_models[0].law);
}

}  // namespace

TEST_CASE("models without parameters are empty blocks", "[parser][friction]") {
  law_of<Frictionless>("begin frictionless model m\n");
  law_of<Tied>("begin tied model m\n");
  law_of<Glued>("begin glued model m\n");
}

TEST_CASE("a constant friction model has a coefficient, 0 if none is given", "[parser][friction]") {
  CHECK(
      law_of<ConstantFriction>("begin constant friction model m\nfriction coefficient = .3\n").coefficient ==
      0.3);
  CHECK(law_of<ConstantFriction>("begin constant friction model m\n").coefficient == 0.0);
  CHECK(bound_contact("begin constant friction model m\nfriction coefficient = -1\nend\n").messages ==
        "a.i:3:24: error: 'friction coefficient' must not be negative, found '-1'\n");
}

TEST_CASE("a spring weld has two displacement functions and a failure", "[parser][friction]") {
  const auto weld = law_of<SpringWeld>(
      "begin spring weld model m\nnormal displacement function = f\nnormal displacement scale factor = 2\n"
      "tangential displacement function = g\ntangential displacement scale factor = 3\n"
      "failure envelope exponent = 1.5\nfailure decay cycles = 10\nfailed model = rub\n");
  CHECK(weld.normal.function->text == "f");
  CHECK(weld.normal.scale_factor == 2.0);
  CHECK(weld.tangential.function->text == "g");
  CHECK(weld.tangential.scale_factor == 3.0);
  CHECK(weld.envelope_exponent == 1.5);
  CHECK(weld.failure.decay_cycles == 10);
  CHECK(weld.failure.failed_model->text == "rub");
}

TEST_CASE("a spring weld has defaults", "[parser][friction]") {
  const auto weld = law_of<SpringWeld>("begin spring weld model m\n");
  CHECK(weld.normal.scale_factor == 1.0);
  CHECK(weld.envelope_exponent == 2.0);
  CHECK(weld.failure.decay_cycles == 1);
  CHECK_FALSE(weld.failure.failed_model);
}

TEST_CASE("a surface weld and an area weld differ in what their capacities are", "[parser][friction]") {
  const std::string lines = "normal capacity = 10\ntangential capacity = 20\nfailure decay cycles = 3\n";
  const auto surface_weld = law_of<SurfaceWeld>("begin surface weld model m\n" + lines);
  CHECK_FALSE(surface_weld.is_per_area);
  CHECK(surface_weld.normal_capacity == 10.0);
  CHECK(surface_weld.tangential_capacity == 20.0);
  CHECK(surface_weld.failure.decay_cycles == 3);
  CHECK(law_of<SurfaceWeld>("begin area weld model m\n" + lines).is_per_area);
  CHECK(std::isnan(law_of<SurfaceWeld>("begin area weld model m\n").normal_capacity));
}

TEST_CASE("an adhesion model has one function of the gap", "[parser][friction]") {
  const auto adhesion =
      law_of<Adhesion>("begin adhesion model m\nadhesion function = f\nadhesion scale factor = 0.5\n")
          .adhesion;
  CHECK(adhesion.function->text == "f");
  CHECK(adhesion.scale_factor == 0.5);
}

TEST_CASE("a cohesive zone model has critical gaps", "[parser][friction]") {
  const auto zone = law_of<CohesiveZone>(
      "begin cohesive zone model m\ntraction displacement function = f\ntraction displacement scale factor = "
      "4\n"
      "critical normal gap = 0.1\ncritical tangential gap = 0.2\n");
  CHECK(zone.traction.function->text == "f");
  CHECK(zone.traction.scale_factor == 4.0);
  CHECK(zone.critical_normal_gap == 0.1);
  CHECK(zone.critical_tangential_gap == 0.2);
}

TEST_CASE("a junction model has a cutoff for its tangential traction", "[parser][friction]") {
  const auto junction = law_of<Junction>(
      "begin junction model m\nnormal traction function = f\nnormal traction scale factor = 2\n"
      "tangential traction function = g\ntangential traction scale factor = 3\n"
      "normal cutoff distance for tangential traction = 0.5\n");
  CHECK(junction.normal.function->text == "f");
  CHECK(junction.normal.scale_factor == 2.0);
  CHECK(junction.tangential.function->text == "g");
  CHECK(junction.tangential.scale_factor == 3.0);
  CHECK(junction.tangential_cutoff == 0.5);
  CHECK_FALSE(law_of<Junction>("begin junction model m\n").tangential_cutoff);
}

TEST_CASE("a threaded model has three functions and a failure envelope", "[parser][friction]") {
  const auto threaded = law_of<Threaded>(
      "begin threaded model m\nnormal traction function = f\nnormal traction scale factor = 2\n"
      "tangential traction function = g\ntangential traction scale factor = 3\n"
      "tangential traction gap function = h\ntangential traction gap scale factor = 4\n"
      "normal capacity = 5\ntangential capacity = 6\nfailure envelope exponent = 7\nfailure decay cycles = "
      "8\n"
      "failed model = glue\n");
  CHECK(threaded.normal.function->text == "f");
  CHECK(threaded.normal.scale_factor == 2.0);
  CHECK(threaded.tangential.function->text == "g");
  CHECK(threaded.tangential.scale_factor == 3.0);
  CHECK(threaded.tangential_gap.function->text == "h");
  CHECK(threaded.tangential_gap.scale_factor == 4.0);
  CHECK(threaded.normal_capacity == 5.0);
  CHECK(threaded.tangential_capacity == 6.0);
  CHECK(threaded.envelope_exponent == 7.0);
  CHECK(threaded.failure.decay_cycles == 8);
  CHECK(threaded.failure.failed_model->text == "glue");
}

TEST_CASE("a model by pressure and velocity has all six numbers", "[parser][friction]") {
  const auto friction = law_of<PressureVelocityFriction>(
      "begin pv_dependent model m\nstatic coefficient = 0.3\ndynamic coefficient = 0.2\nvelocity decay = 4\n"
      "reference pressure = 1.0e5\noffset pressure = 10\npressure exponent = 1.5\n");
  CHECK(friction.static_coefficient == 0.3);
  CHECK(friction.dynamic_coefficient == 0.2);
  CHECK(friction.velocity_decay == 4.0);
  CHECK(friction.reference_pressure == 1.0e5);
  CHECK(friction.offset_pressure == 10.0);
  CHECK(friction.pressure_exponent == 1.5);
  law_of<PressureVelocityFriction>("begin pv dependent model m\n");
}

TEST_CASE("hybrid and time variant models select among others", "[parser][friction]") {
  const auto hybrid =
      law_of<HybridFriction>("begin hybrid model m\ninitially close = glue\ninitially far = rub\n");
  CHECK(hybrid.initially_close->text == "glue");
  CHECK(hybrid.initially_far->text == "rub");
  const auto variant = law_of<TimeVariantFriction>(
      "begin time variant model m\nmodel = glue during periods p1 p2\nmodel rub during period p3\n");
  REQUIRE(variant.models.size() == 2);
  CHECK(variant.models[0].model.text == "glue");
  CHECK(joined_names(variant.models[0].periods) == "p1 p2");
  CHECK(joined_names(variant.models[1].periods) == "p3");
}

TEST_CASE("a friction model must have a name", "[parser][friction]") {
  CHECK(bound_contact("begin tied model\nend\n").messages ==
        "a.i:2:12: error: the block 'model' needs a name\n");
}

TEST_CASE("a model of user subroutines is refused", "[parser][friction]") {
  CHECK(bound_contact("begin user subroutine model m\nend\n").messages ==
        "a.i:2:7: error: block 'user subroutine model' is not supported and would change the answer; "
        "user subroutines cannot be run\n");
}
