// SPDX-License-Identifier: BSD-3-Clause
// Contact of lofted shells as a run has it: what touches, and what the nodes get of it.
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::string formulation(const std::string& name) { return "constraint formulation = " + name + "\n"; }

std::string self_contact(const std::string& more) { return general_contact("self contact = on\n" + more); }

/// Adds a sheet whose shells all have one thickness.
void add_plate(MeshBuilder& b, const Sheet& sheet, double thickness) {
  b.add_shells(sheet);
  const auto n = static_cast<std::size_t>(sheet.cells[0] * sheet.cells[1]);
  b.set_attributes(sheet.id, {"thickness"}, std::vector<double>(n, thickness));
}

/// Two plates of thickness 2 whose middles are 5 apart, as OptiStruct's guide has them.
MeshBuilder two_plates() {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {2, 2}, .u = {8, 0, 0}, .v = {0, 8, 0}}, 2.0);
  add_plate(b, {.id = 2, .cells = {3, 3}, .origin = {1, 1, 5}, .u = {5, 0, 0}, .v = {0, 5, 0}}, 2.0);
  return b;
}

/// A cube over the ridge of a roof, to one side.
MeshBuilder cube_on_roof() {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}, .origin = {-3, 0, -0.6}, .u = {3, 0, 0.6}, .v = {0, 3, 0}}, 0.4);
  add_plate(b, {.id = 2, .cells = {3, 3}, .u = {3, 0, -0.6}, .v = {0, 3, 0}}, 0.4);
  b.add_hexes({.id = 3, .cells = {2, 2, 1}, .origin = {-0.5, 0.3, 0.25}, .size = {1.2, 0.9, 0.6}});
  return b;
}

}  // namespace

TEST_CASE("plates 5 apart and 2 thick touch after 3 of travel", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  ContactBodies bodies(two_plates(), general_contact(formulation(name)));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(1.5);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(1.5 - 1e-6);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(2e-6);
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
  CHECK(bodies.moments.colwise().norm().maxCoeff() < 1e-12);  // the force goes through the middle
}

TEST_CASE("a push on a roof is a force and a moment on its nodes", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  ContactBodies bodies(cube_on_roof(), general_contact(formulation(name)));
  bodies.ask();
  bodies.set_velocity(2, {0, 0, -1});
  for (int i = 0; i < 10; ++i) bodies.step(0.01);
  REQUIRE(bodies.force_on(2).z() > 1e-3);
  // At the ridge skins stand off along the mean of the two normals, and forces along the normal of one.
  CHECK(bodies.moments.colwise().norm().maxCoeff() > 1e-4 * bodies.force_size());
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
  CHECK(bodies.net_moment().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("a plate pinched between two blocks is in balance", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {4, 4}, .u = {4, 0, 0}, .v = {0, 4, 0}}, 0.5);
  b.add_hexes({.id = 2, .cells = {3, 3, 1}, .origin = {0.5, 0.5, 0.24}, .size = {3, 3, 1}});
  b.add_hexes({.id = 3, .cells = {3, 3, 1}, .origin = {0.5, 0.5, -1.24}, .size = {3, 3, 1}});
  ContactBodies bodies(b, general_contact(formulation(name)));
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 1e-3);
  CHECK(bodies.force_on(2).z() == Approx(-bodies.force_on(1).z()));
  CHECK(bodies.force_on(0).norm() < 1e-12);
}

TEST_CASE("shells that the mesh joins do not touch at rest, however thick and fine", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  const double thickness = GENERATE(0.02, 0.1, 0.35);  // elements are 0.1 long
  MeshBuilder b;
  const std::array<int, 2> cells{10, 10};
  SECTION("flat") { add_plate(b, {.id = 1, .cells = cells}, thickness); }
  SECTION("folded at a right angle") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {1, 0, 0}, .u = {0, 1, 0}, .v = {0, 0, 1}}, thickness);
  }
  SECTION("folded sharply") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {1, 0, 0}, .u = {0, 1, 0}, .v = {-0.6, 0, 0.8}},
              thickness);
  }
  SECTION("as a T") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {0.5, 0, 0}, .u = {0, 1, 0}, .v = {0, 0, 1}}, thickness);
  }
  SECTION("standing on a solid") {
    b.add_hexes({.id = 1, .cells = {10, 10, 2}, .size = {1, 1, 0.2}});
    add_plate(b, {.id = 2, .cells = cells, .origin = {0.5, 0, 0.2}, .u = {0, 1, 0}, .v = {0, 0, 1}}, thickness);
  }
  SECTION("lying on a part of a solid") {
    b.add_hexes({.id = 1, .cells = {10, 10, 2}, .size = {1, 1, 0.2}});
    add_plate(b, {.id = 2, .cells = {5, 10}, .origin = {0, 0, 0.2}, .u = {0.5, 0, 0}, .v = {0, 1, 0}},
              thickness);
  }
  ContactBodies bodies(b, self_contact(formulation(name)));
  bodies.ask();
  CHECK(bodies.force_size() == 0.0);
  bodies.step(0.1);
  CHECK(bodies.force_size() == 0.0);
}

TEST_CASE("plates that turn carry their skins along", "[contact][lofted]") {
  ContactBodies bodies(two_plates(), general_contact());
  bodies.ask();
  bodies.turning.row(0).setConstant(0.25);
  bodies.dt = 0.0;
  bodies.ask();
  MovingSurface surface(bodies.contact.faces());
  surface.move_nodes(bodies.motion());
  const auto first = static_cast<std::uint32_t>(bodies.contact.faces().n_mesh_points());
  REQUIRE(surface.arms().cols() == 2 * (9 + 16));
  CHECK(surface.arms().colwise().norm().isApproxToConstant(1.0));
  // Turning about x, what stands up goes along -y.
  const double height = surface.arms()(2, 0);
  CHECK((surface.v(first) - Eigen::Vector3d(0, -0.25 * height, 0)).norm() < 1e-12);
}
