// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/body_volumes.hpp"

#include "contact/overlap/point_box.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A cube of eight elements, nodes 0 to 26, and a plate of one shell above it, as thick as 0.1.
MeshBuilder cube_and_plate() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}});
  add_plate(b, {.id = 2, .origin = {0, 0, 1.5}, .share_nodes = false}, 0.1);
  return b;
}

}  // namespace

TEST_CASE("thick bodies are solids and lofted shells, each with its box", "[contact][overlap]") {
  ContactBodies bodies(cube_and_plate(), general_contact());
  bodies.ask();
  const BodyVolumes volumes(bodies.mesh, bodies.contact.contact_mesh());
  CHECK(volumes.thick_bodies() == std::vector<std::uint32_t>{0, 27});
  CHECK(volumes.number_of_body(13) == OptionalIndex<std::uint32_t>(0u));
  CHECK(volumes.number_of_body(28) == OptionalIndex<std::uint32_t>(1u));
  const auto boxes = volumes.boxes(bodies.x, bodies.contact.kinematics());
  REQUIRE(boxes.size() == 2);
  CHECK(boxes[0].hi[2] == 1.0);
  CHECK(boxes[1].lo[2] == Approx(1.45));
  CHECK(boxes[1].hi[2] == Approx(1.55));
}

TEST_CASE("volumes near a box are those that meet it, of living elements", "[contact][overlap]") {
  ContactBodies bodies(cube_and_plate(), general_contact());
  bodies.ask();
  std::vector<contactsim::Box> near(2, empty_box());
  add_point({0.1, 0.1, 0.1}, near[0]);
  std::vector<std::uint8_t> alive(9, 1);
  const BodyVolumes volumes(bodies.mesh, bodies.contact.contact_mesh(), alive);
  const auto corner = volumes.near(bodies.x, bodies.contact.kinematics(), near);
  REQUIRE(corner.size() == 1);
  CHECK(corner[0].element == ElementIndex{0});
  CHECK(corner[0].body == 0);
  CHECK(corner[0].shape == Shape::hex8);
  CHECK(corner[0].corners.col(0).isZero(0.0));
  alive[0] = 0;
  CHECK(volumes.near(bodies.x, bodies.contact.kinematics(), near).empty());
  add_point({0.5, 0.5, 1.5}, near[1]);
  const auto loft = volumes.near(bodies.x, bodies.contact.kinematics(), near);
  REQUIRE(loft.size() == 1);
  CHECK(loft[0].element == ElementIndex{8});
  CHECK(loft[0].body == 27);
  CHECK(loft[0].corners.row(2).maxCoeff() - loft[0].corners.row(2).minCoeff() == Approx(0.1));
}
