// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/pair_history_warnings.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/flying_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Warn = void (*)(IndexedSpan<PairIndex, const PairHistory>, const ContactModel&, const Mesh&,
                      Diagnostics&);

/// What is said of the only pair of a cube before another one.
std::string said_by(Warn warn, const PairHistory& history) {
  const FlyingCube cube;
  IndexedVector<PairIndex, PairHistory> histories;
  histories.push_back(history);
  Diagnostics said;
  warn(histories, cube.contact, cube.mesh, said);
  return messages(said);
}

}  // namespace

TEST_CASE("sides deeper in each other than a tenth of the thickness are reported", "[app][contact]") {
  PairHistory history;
  history.deepest = 0.03;
  history.deepest_share = 0.1;
  CHECK(said_by(warn_of_depths, history).empty());
  history.deepest_share = 0.12;
  const std::string said = said_by(warn_of_depths, history);
  CHECK(said.find(
            "'lower' and 'upper' have penetrated each other by 0.03, 12 % of the thickness behind them") !=
        std::string::npos);
  CHECK(said.find("[contact-penetration]") != std::string::npos);
}

TEST_CASE("contact that ended deep is reported with its first place", "[app][contact]") {
  PairHistory history;
  history.n_lost = 2;
  history.lost_node = {4};
  history.lost_time = 0.25;
  history.lost_depth = 0.125;
  CHECK(
      said_by(warn_of_depths, history)
          .find("ended at time 0.25 at node 5, 0.125 deep: one side has got past the other (2 places in the "
                "run) [contact-lost]") != std::string::npos);
}

TEST_CASE("pairs of infinitesimal sliding that have left their faces are reported", "[app][contact]") {
  PairHistory history;
  history.slid_share = 0.5;
  CHECK(said_by(warn_of_small_sliding, history).empty());
  history.slid_share = 0.75;
  history.slid_node = {6};
  history.n_released = 1;
  history.released_node = {7};
  const std::string said = said_by(warn_of_small_sliding, history);
  CHECK(said.find("have slid off their faces of the start, at node 7 by 0.75 of a face") !=
        std::string::npos);
  CHECK(said.find("1 place lost their faces of the start to element death, the first at node 8") !=
        std::string::npos);
}
