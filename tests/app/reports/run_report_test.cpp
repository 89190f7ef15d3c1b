// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_report.hpp"

#include <fmt/format.h>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using Catch::Contains;

// A press fit without springs: the ramp's work of 2 is external, contact gave it out where sides met, to the
// parts that hold it. 0.25 came out of overlaps of the mesh besides.
TEST_CASE("what a ramped overlap puts in is neither held by contact nor lost", "[app][report]") {
  Energies energies;
  energies.external = 2.0;
  energies.internal = 2.125;
  energies.friction = 0.125;
  energies.impact = -2.25;
  energies.contact = -0.125;  // friction, impact and the work of the ramp
  const std::string text = format_energy_balance(energies, 0.0, 0.25, 2.0);
  const auto row = [](const char* name, double energy) {
    return Contains(fmt::format("\n  {:<30} {:>13.5e}\n", name, energy));
  };
  CHECK_THAT(text, row("put in by the start, overlaps", 0.25));
  CHECK_THAT(text, row("work of loads and motion", 2.0));
  CHECK_THAT(text, row("held by contact", 0.0));
  CHECK_THAT(text, row("lost where sides met", 0.0));
}

TEST_CASE("the log says in a line how ranks share a run and what the busiest sends", "[app][report]") {
  const RankTraffic traffic{64, 0.125, 0.034, 800, 63, 72000000, 150000000};
  const std::string line = format_ranks(traffic, false);
  CHECK(line ==
        "  64 ranks: 12.5 % of the nodes shared, the busiest has 3.4 % more elements and sends 72000000 "
        "bytes to 63 "
        "a step\n");
  CHECK(line.size() < 120);  // longer ones are wrapped
  const std::string of_trials = format_ranks(traffic, true);
  CHECK(of_trials ==
        "  64 ranks: the busiest has 3.4 % more elements and sends 72000000 bytes to 63 a trial, all get "
        "800\n");
  CHECK(of_trials.size() < 120);
}

TEST_CASE("the log says what is subcycled, and what that saves", "[app][report][subcycler]") {
  const Mesh mesh = test::MeshBuilder().add_hexes({}).build();
  Model model;
  model.mesh = &mesh;
  StepReport at_start{0.5, std::nullopt};
  CHECK_THAT(format_model(model, at_start), !Contains("subcycling"));
  model.subcycles = {{NodeIndex{0}}, 20, 980, 10};
  CHECK_THAT(format_model(model, at_start),
             Contains("\n  subcycling: 20 elements in 10 parts of each step, 980 once: 8.47 times fewer are "
                      "advanced\n"));
}
