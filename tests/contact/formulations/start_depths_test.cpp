// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/start_depths.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A cube of a side of 0.8 that lies on one cell of a plate of 3 x 1, 0.3 deep.
MeshBuilder cube_in_plate() {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {3, 1, 1}, .size = {3, 1, 1}});
  builder.add_hexes({.id = 2, .origin = {0.1, 0.1, 0.7}, .size = {0.8, 0.8, 0.8}, .share_nodes = false});
  return builder;
}

std::string as_formulation() {
  return GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n");
}

}  // namespace

TEST_CASE("what overlaps at the start is pushed out by a spring", "[contact][start_depths]") {
  ContactBodies bodies(cube_in_plate(), general_contact(as_formulation()));
  bodies.ask();
  const double at_start = bodies.force_on(1).z();
  REQUIRE(at_start > 0.0);
  CHECK(bodies.contact.stored() == Approx(0.5 * at_start * 0.3));
  for (const double depth : {0.2, 0.1}) {
    bodies.set_velocity(1, {0, 0, 0.1});
    bodies.step(1.0);
    CHECK(bodies.force_on(1).z() == Approx(at_start * depth / 0.3));
  }
}

TEST_CASE("a face that overlapped at the start is a spring to its next partner", "[contact][start_depths]") {
  ContactBodies bodies(cube_in_plate(), general_contact(as_formulation()));
  bodies.ask();
  const double at_start = bodies.force_on(1).z();
  bodies.set_velocity(1, {0.1, 0, 0});
  for (int step = 0; step < 10; ++step) bodies.step(1.0);
  CHECK(bodies.force_on(1).z() == Approx(at_start));
}

TEST_CASE("the depths of the start survive a restart", "[contact][start_depths]") {
  ContactBodies straight(cube_in_plate(), general_contact(as_formulation()));
  straight.ask();
  straight.step(1.0);
  StateArchive saved;
  straight.contact.archive(straight.motion(), saved);
  const SavedState state = saved.take();
  ContactBodies restarted(cube_in_plate(), general_contact(as_formulation()));
  StateArchive restored(state);
  restarted.contact.archive(straight.motion(), restored);
  for (ContactBodies* bodies : {&straight, &restarted}) bodies->step(1.0);
  CHECK(restarted.force_on(1).z() > 0.0);
  CHECK(restarted.forces == straight.forces);
}
