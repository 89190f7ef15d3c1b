// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/reach_warnings.hpp"

#include "core/definition/contact.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/flying_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// What is said of a cube 0.01 before another one whose contact has these lines.
std::string reach_said(const std::string& lines) {
  FlyingCube cube({.contact = lines});
  cube.run(0);
  Diagnostics said;
  warn_of_reach(*cube.simulation.contact_force(), cube.contact, *cube.region().contact, said);
  return messages(said);
}

std::string reach_said_of_pair(const std::string& lines) {
  return reach_said("begin interaction\nsurfaces = lower upper\n" + lines + "end\n");
}

std::string reach_said_of_all(const std::string& lines) {
  return reach_said("begin interaction defaults\ngeneral contact = on\n" + lines + "end\n");
}

}  // namespace

TEST_CASE("lines about reach that do what they say are nothing to tell", "[app][reach]") {
  CHECK(reach_said_of_all("") == "");
  CHECK(reach_said_of_pair("search distance = 0.02\n") == "");
  CHECK(reach_said_of_pair("capture tolerance = 0.05\nfriction model = tied\n") == "");
  CHECK(reach_said_of_pair("interaction behavior = infinitesimal_sliding\n") == "");
}

TEST_CASE("a capture tolerance of a law that holds nothing is reported", "[app][reach]") {
  CHECK_THAT(
      reach_said_of_pair("capture tolerance = 0.05\n"),
      Contains("warning: CAPTURE TOLERANCE has no effect: the law 'frictionless' holds nothing at the start; "
               "GAP CLOSURE TOLERANCE moves nodes onto the other side [capture-without-effect]\n"));
  CHECK_THAT(reach_said_of_all("capture tolerance = 0.05\n"), Contains("[capture-without-effect]"));
}

TEST_CASE("a search distance within which nothing lies is reported for a pair, or once of all",
          "[app][reach]") {
  CHECK_THAT(
      reach_said_of_pair("search distance = 0.005\n"),
      Contains("warning: lower to upper: nothing is within the SEARCH DISTANCE of 0.005, so that they never "
               "meet; the pair table has the smallest gap [search-distance-empty]\n"));
  CHECK_THAT(
      reach_said_of_all("search distance = 0.005\n"),
      Contains("warning: nothing of any pair is within the SEARCH DISTANCE, so that none of them ever meets; "
               "the pair table has the smallest gaps [search-distance-empty]\n"));
}
