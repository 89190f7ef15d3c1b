// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/contact_report.hpp"

#include <regex>

#include "core/definition/contact.hpp"
#include "support/catch.hpp"
#include "support/flying_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

std::string start_of(FlyingCube& cube) {
  const Simulation& run = cube.simulation;
  return format_contact_start(*cube.simulation.contact_force(), *run.contact_model(), run.untied(),
                              cube.mesh);
}

const std::string tied_pair = "begin interaction\nsurfaces = lower upper\nfriction model = tied\n";

}  // namespace

TEST_CASE("contact that holds nothing starts with the penalty behind its faces alone", "[app][report]") {
  FlyingCube cube;
  cube.run(0);
  CHECK(std::regex_match(
      start_of(cube),
      std::regex("  automatic penalty behind the faces from [1-9]\\S* to [1-9]\\S* force/length\\^3\n")));
}

TEST_CASE("a tied pair starts with its ties and their area", "[app][report]") {
  FlyingCube cube({.contact = tied_pair + "capture tolerance = 0.05\nend\n"});
  cube.run(0);
  CHECK_THAT(start_of(cube), Contains("  tied: lower to upper, ") && Contains(" over an area of 1\n") &&
                                 !Contains("not tied:"));
}

TEST_CASE("a search distance is reported with what is as near", "[app][report]") {
  const auto reported = [](const std::string& distance) {
    FlyingCube cube(
        {.contact = "begin interaction\nsurfaces = lower upper\nsearch distance = " + distance + "\nend\n"});
    cube.run(0);
    return start_of(cube);
  };
  CHECK_THAT(reported("0.5"), Contains("  search distance 0.5: lower to upper, what is as near now\n"));
  CHECK_THAT(reported("0.005"), Contains("  search distance 0.005: lower to upper, nothing is as near\n"));
}

TEST_CASE("a run ends with what its search did, and the share of its stable step", "[app][report]") {
  FlyingCube cube;
  cube.run_to_end();
  const ContactForce& force = *cube.simulation.contact_force();
  const std::string text = format_contact(force, false);
  // 24 faces of the lower cube, 6 of the upper one.
  CHECK_THAT(text,
             Contains("\nContact search\n  30 contact faces, ") && Contains(" contact nodes, 0 ties\n"));
  CHECK_THAT(text, Contains(" bytes, ") && Contains(" per face\n"));
  CHECK_THAT(text, Contains("  contact lowers the stable time step by "));
  CHECK_THAT(format_contact(force, true), !Contains("stable time step"));
}
