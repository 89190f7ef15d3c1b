// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/interpenetration_warnings.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/flying_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// What is said of the only pair of a cube before another one.
std::string said_of_pair(const Interpenetration& one) {
  FlyingCube cube;
  cube.run(0);
  IndexedVector<PairIndex, Interpenetration> found;
  found.push_back(one);
  Diagnostics said;
  warn_of_interpenetration(*cube.simulation.contact_force(), cube.contact, cube.mesh, found, said);
  return messages(said);
}

}  // namespace

TEST_CASE("bodies that lie in each other by more than a fifth of a thickness are reported",
          "[app][contact]") {
  Interpenetration one;
  CHECK(said_of_pair(one) == "");
  one.depth = 0.15;
  one.share = 0.2;
  one.time = 0.25;
  one.node = 30;
  one.n_nodes = 4;
  CHECK(said_of_pair(one) == "");
  one.share = 0.3;
  const std::string said = said_of_pair(one);
  CHECK(said.find(
            "warning: the bodies of 'lower' and 'upper' lie in each other at time 0.25: node 31 is 0.15 "
            "inside the "
            "other, 30 % of the thickness (4 nodes there); contact does not hold them apart; smaller steps, "
            "finer faces or the other CONSTRAINT FORMULATION may [interpenetration]\n") != std::string::npos);
  one.depth = 0.0;  // which contact's own penetration says
  CHECK(said_of_pair(one) == "");
}

TEST_CASE("nodes that went through a shell are reported with the first of them", "[app][contact]") {
  Interpenetration one;
  one.n_crossed = 1;
  one.crossed_node = 4;
  one.crossed_time = 0.5;
  const std::string said = said_of_pair(one);
  CHECK(said.find(
            "warning: 'lower' and 'upper': node 5 has gone through the mid surface of the other by time 0.5 "
            "(1 passage in the run) [passed-through]\n") != std::string::npos);
  one.n_crossed = 3;
  CHECK(said_of_pair(one).find("(3 passages in the run)") != std::string::npos);
}
