// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/subcycle_refusals.hpp"

#include "app/run/simulation.hpp"
#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/two_cube_input.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A rod low with a flat element high at its end; side sets 10 and 11 are at the other end.
Mesh rod_with_flat_end() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "low", .cells = {40, 1, 1}, .size = {40, 1, 1}});
  b.add_hexes({.id = 2, .name = "high", .origin = {40, 0, 0}, .size = {0.1, 1, 1}});
  const auto top = [](double end) {
    return [end](const CandidateSide& side) { return side.normal.z() > 0.5 && side.centroid.x() < end; };
  };
  b.add_side_set(10, "far", top(2.0));
  b.add_side_set(11, "all_along", top(41.0));
  return b.build();
}

const std::string line = "subcycle blocks = high\n";
const std::string death =
    "begin element death d\nblock = low\ncriterion is element value of von_mises > 1e9\nend\n";

std::string contact_of(const std::string& surface) {
  return "begin contact definition c\ncontact surface s contains " + surface +
         "\nbegin interaction defaults\nself contact = on\nend\nend\n";
}

/// What is said of a region with these lines; "" of one that runs.
std::string said_of(const std::string& lines) {
  TwoCubeInput rod(rod_with_flat_end(), two_cube_deck(text_of({.region = lines})));
  try {
    Simulation simulation(rod.input(), {}, rod.diagnostics);
    simulation.begin();
    simulation.step();
  } catch (const DeckError&) {
  }
  return messages(rod.diagnostics);
}

}  // namespace

TEST_CASE("contact is refused at subcycled nodes alone", "[app][subcycler]") {
  CHECK(said_of(line) == "");
  CHECK(said_of(line + contact_of("far")) == "");
  CHECK(said_of(contact_of("all_along")) == "");
  const std::string said = said_of(line + contact_of("all_along"));
  CHECK(said.find("error: contact at nodes of subcycled elements is not supported: ") != std::string::npos);
  CHECK(said.find("d.i:") == 0);
}

TEST_CASE("deaths may not bare subcycled elements to contact", "[app][subcycler]") {
  CHECK(said_of(line + death) == "");
  CHECK(said_of(death + contact_of("far")) == "");
  CHECK(said_of(line + death + contact_of("far"))
            .find("contact and element death together with SUBCYCLE BLOCKS") != std::string::npos);
}
