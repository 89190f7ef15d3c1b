// SPDX-License-Identifier: BSD-3-Clause
// Rods of unlike radii that meet have the least of them at their node, and taper towards it.
#include <numbers>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

void add_rod_of(MeshBuilder& b, const Row& row, double radius) {
  b.add_beams(row);
  b.set_attributes(
      row.id, {"area"},
      std::vector<double>(static_cast<std::size_t>(row.cells), radius * radius * std::numbers::pi));
}

/// A rod of radius 0.1 from x = 0 to 1, joined there to one of 0.05 from x = -1, and a third one of 0.05
/// across them at x and height z.
MeshBuilder joined_rods(double x, double z) {
  MeshBuilder b;
  add_rod_of(b, {.id = 1, .from = {0, 0, 0}, .to = {1, 0, 0}}, 0.1);
  add_rod_of(b, {.id = 2, .from = {-1, 0, 0}, .to = {0, 0, 0}}, 0.05);
  add_rod_of(b, {.id = 3, .from = {x, -1, z}, .to = {x, 1, z}}, 0.05);
  return b;
}

bool touch(double x, double z) {
  ContactBodies bodies(joined_rods(x, z), general_contact("penalty stiffness = 1e4\n"));
  bodies.ask();
  return bodies.force_on(2).z() > 0.0;
}

/// The distance of the axes at which rods touch: rod_at(x) is that on one side of it.
void check_touch(double x, double distance) {
  CAPTURE(x);
  CHECK(touch(x, distance - 1e-4));
  CHECK_FALSE(touch(x, distance + 1e-4));
}

}  // namespace

TEST_CASE("a rod tapers to the thinner one that it is joined to", "[contact][edge_edge][lofting]") {
  check_touch(0.1, 0.105);
  check_touch(0.5, 0.125);
  check_touch(0.9, 0.145);
  check_touch(-0.5, 0.1);  // the thin one is thin all along
}

TEST_CASE("the sphere about a node has the least radius of its rods, of whatever surface",
          "[contact][edge_edge][lofting]") {
  ContactParts parts(joined_rods(0.5, 1.0), general_contact());
  for (const SurfaceNode& node : parts.contact_mesh.surface_nodes) {
    const double x = parts.kinematics.x(node.node).x();
    if (x == 0.0) CHECK(node.radius == Approx(0.05));
    if (x == 1.0) CHECK(node.radius == Approx(0.1));
  }
}

TEST_CASE("a tapered pair pushes alike on both sides", "[contact][edge_edge][lofting]") {
  ContactBodies bodies(joined_rods(0.1, 0.1), general_contact());
  bodies.ask();
  CHECK(bodies.force_size() > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
}
