// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/refusals.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/mesh_builder.hpp"
#include "support/report_region.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// What is said of the only region of a definition.
std::string refused_of(const SimulationDefinition& definition) {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).build();
  const Procedure& procedure = definition.procedures.front();
  Diagnostics said;
  refuse_what_is_missing({definition, procedure, procedure.regions.front(), mesh}, said);
  return messages(said);
}

/// The same of a deck d.i with these lines of a region, which begin at line 13.
std::string refused_of(const std::string& lines, bool is_implicit = false) {
  SimulationDefinition definition = deck_of_region(lines);
  if (is_implicit) definition.procedures.front().implicit_by = ImplicitCause{};
  return refused_of(definition);
}

const std::string in_statics = " in a quasi-static procedure is not supported";

}  // namespace

TEST_CASE("a plain region is refused nothing, explicit or in load steps", "[app][refusals]") {
  const std::string lines = "begin fixed displacement\nblock = block_1\ncomponents = x\nend";
  CHECK(refused_of(lines) == "");
  CHECK(refused_of(lines, true) == "");
}

TEST_CASE("what is not acted on yet is refused at its line, what changes nothing warned about",
          "[app][refusals]") {
  SimulationDefinition definition = deck_of_region("");
  Region& region = definition.procedures.front().regions.front();
  region.spot_welds.resize(2);
  region.mass_properties.resize(1);
  CHECK(refused_of(definition) ==
        "error: a spot weld is not supported in a run yet\n  1 more like this\n"
        "warning: mass properties are not reported yet; the log has the mass of every block "
        "[mass-properties]\n");
}

TEST_CASE("load steps refuse what moves by inertia, at its line", "[app][refusals]") {
  const std::string velocity = "begin initial velocity\nblock = block_1\ncomponent = x\nmagnitude = 1\nend";
  CHECK(refused_of(velocity) == "");
  CHECK(refused_of(velocity, true) == "d.i:13:1: error: an initial velocity" + in_statics + "\n");
  const std::string driven =
      "begin prescribed {}\nblock = block_1\ncomponent = x\nfunction = sierra_constant_function_one\nend";
  const auto drive = [&](const std::string& what) {
    std::string lines = driven;
    return refused_of(lines.replace(lines.find("{}"), 2, what), true);
  };
  CHECK(drive("displacement") == "");
  CHECK(drive("acceleration") ==
        "d.i:13:1: error: a prescribed acceleration" + in_statics +
            "; PRESCRIBED DISPLACEMENT says where nodes go, GRAVITY loads all of them\n");
  SimulationDefinition definition = deck_of_region("");
  Procedure& procedure = definition.procedures.front();
  procedure.regions.front().mass_scalings.resize(1);
  procedure.regions.front().viscous_dampings.resize(1);
  CHECK(refused_of(definition) == "");
  procedure.implicit_by = ImplicitCause{};
  CHECK(refused_of(definition) ==
        "error: mass scaling" + in_statics + "\nerror: viscous damping" + in_statics + "\n");
}

TEST_CASE("load steps, which have no stable step, refuse to be subcycled", "[app][refusals][subcycler]") {
  CHECK(refused_of("subcycle blocks = all") == "");
  CHECK(refused_of("subcycle blocks = all", true) ==
        "d.i:13:19: error: SUBCYCLE BLOCKS" + in_statics + "; load steps have no stable step\n");
}

TEST_CASE("load steps refuse deaths that equilibrium does not know", "[app][refusals][death]") {
  SimulationDefinition definition = deck_of_region("");
  Procedure& procedure = definition.procedures.front();
  procedure.implicit_by = ImplicitCause{};
  ElementDeath& death = procedure.regions.front().element_deaths.emplace_back();
  CHECK(refused_of(definition) == "");
  death.erodes_nodes = false;
  CHECK(refused_of(definition) == "");  // nothing touches
  procedure.regions.front().contact.emplace();
  CHECK(refused_of(definition) ==
        "error: NODAL EROSION = OFF" + in_statics + "; a node without elements has no equilibrium\n");
  death.erodes_nodes = true;
  death.on_inversion = true;
  CHECK(refused_of(definition).starts_with("error: DEATH ON INVERSION" + in_statics + "; "));
}

TEST_CASE("a run needs a procedure with times, and reports what it lacks", "[app][refusals]") {
  SimulationDefinition definition = deck_of_region("");
  definition.procedures.front().time_control.reset();
  CHECK(refused_of(definition) ==
        "d.i:4:24: error: the procedure has no TIME CONTROL; without one --tables alone can be asked for\n");
  SimulationDefinition fragment;
  fragment.procedures.emplace_back().regions.emplace_back();
  CHECK(refused_of(fragment) ==
        "error: the procedure has no TIME CONTROL; without one --tables alone can be asked for\n");
}
