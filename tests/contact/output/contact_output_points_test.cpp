// SPDX-License-Identifier: BSD-3-Clause
// What contact points and ties add to the variables of nodes and totals.
#include "contact/output/contact_output.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"
#include "support/lofted_meshes.hpp"
#include "support/watched_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string tied_pair = "penalty stiffness = 1000\nfriction model = tied\n";

}  // namespace

TEST_CASE("ties show their forces, and none outside their periods", "[contact][contact_output]") {
  WatchedContact bodies(
      cube_over_cube(0.0),
      general_contact("penalty stiffness = 1000\nfriction model = tied\n",
                      "contact surface low contains block_1\ncontact surface high contains block_2\n"));
  bodies.ask();
  bodies.shift(1, {0, 0, 0.01});
  bodies.ask();
  bodies.take(1);
  CHECK((bodies.global("contact_force_high") + Vector3d(0, 0, 10)).norm() < 1e-10);
  CHECK((bodies.global("contact_force_low") - Vector3d(0, 0, 10)).norm() < 1e-10);
  CHECK(bodies.global("contact_area_low_high").x() == Approx(1.0));
  CHECK(bodies.nodal("contact_normal_force_magnitude").row(0).sum() == Approx(20.0));
}

TEST_CASE("the area of ties is shared by the nodes of both sides, of triangles by three each",
          "[contact][contact_output]") {
  const std::string form = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const bool is_of_tets = GENERATE(false, true);
  MeshBuilder b;
  if (is_of_tets) {
    b.add_tets({.id = 1}).add_tets({.id = 2, .origin = {0, 0, 1}, .share_nodes = false});
  } else {
    b = cube_over_cube(0.0);
  }
  WatchedContact bodies(b, general_contact(tied_pair + form));
  bodies.ask();
  bodies.shift(1, {0, 0, 0.01});
  bodies.ask();
  bodies.take(1);
  CAPTURE(form, is_of_tets);
  CHECK(bodies.force_on(1).z() == Approx(-10.0));
  const double area = bodies.global("contact_area_block_1").x();
  CHECK(area == Approx(1.0));
  CHECK(bodies.nodal("contact_area").row(0).sum() == Approx(2.0 * area));
  CHECK((bodies.global("contact_centre_block_1").head<2>() - Eigen::Vector2d(0.5, 0.5)).norm() < 1e-9);
  const Eigen::Matrix3Xd normal = bodies.nodal("contact_normal_force"),
                         along = bodies.nodal("contact_tangential_force");
  CHECK((normal + along - bodies.forces).norm() < 1e-12);
  CHECK(bodies.nodal("contact_slip_status").maxCoeff() == 1.0);
}

TEST_CASE("a tie that shears has that along the surface", "[contact][contact_output]") {
  WatchedContact bodies(cube_over_cube(0.0), general_contact(tied_pair));
  bodies.ask();
  bodies.shift(1, {0.002, 0, 0.01});
  bodies.ask();
  bodies.take(1);
  CHECK((bodies.global("contact_normal_force_block_2") - Vector3d(0, 0, -10)).norm() < 1e-9);
  CHECK((bodies.global("contact_friction_force_block_2") - Vector3d(-2, 0, 0)).norm() < 1e-9);
  CHECK((bodies.global("contact_friction_force_block_1") - Vector3d(2, 0, 0)).norm() < 1e-9);
}

TEST_CASE("a node that touches several things has its deepest gap and the number of the last pair",
          "[contact][contact_output]") {
  // A cube over the edge between two plates, 0.01 deep in the one and 0.03 in the other.
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1, 0, 0}, .size = {1, 1, 1.02}, .share_nodes = false});
  b.add_hexes({.id = 3, .origin = {0.6, 0.1, 0.99}, .size = {0.8, 0.8, 0.8}, .share_nodes = false});
  WatchedContact bodies(b, general_contact("penalty stiffness = 1000\n"));
  bodies.ask();
  bodies.take(0);
  const Eigen::Matrix3Xd gap = bodies.nodal("contact_normal_gap"), pair = bodies.nodal("contact_interaction"),
                         force = bodies.nodal("contact_normal_force");
  // Pairs by surfaces: 1 and 2, 1 and 3, 2 and 3.
  for (Eigen::Index i = 16; i < 24; ++i) {
    if (bodies.x(2, i) > 1.5) continue;
    CHECK(gap(0, i) == Approx(-0.03));
    CHECK(pair(0, i) == 3.0);
  }
  for (Eigen::Index i = 4; i < 8; ++i) CHECK(gap(0, i) == Approx(-0.01));
  CHECK(force.rightCols(8).row(2).sum() == Approx(1000.0 * 0.4 * 0.8 * (0.01 + 0.03)));
  CHECK((bodies.global("contact_force_block_1") - Vector3d(0, 0, -3.2)).norm() < 1e-9);
  CHECK((bodies.global("contact_force_block_2_block_3") - Vector3d(0, 0, -9.6)).norm() < 1e-9);
  CHECK((bodies.global("contact_centre_block_1").head<2>() - Eigen::Vector2d(0.8, 0.5)).norm() < 1e-9);
}

TEST_CASE("a shell that is squeezed has the areas of both of its sides and no force",
          "[contact][contact_output]") {
  MeshBuilder b;
  add_plate(b, {.id = 1}, 0.2);
  b.add_hexes({.id = 2, .origin = {0, 0, 0.09}, .share_nodes = false});
  b.add_hexes({.id = 3, .origin = {0, 0, -1.09}, .share_nodes = false});
  WatchedContact bodies(b, general_contact("penalty stiffness = 1000\n"));
  bodies.ask();
  bodies.take(0);
  const Eigen::Matrix3Xd area = bodies.nodal("contact_area"), force = bodies.nodal("contact_normal_force"),
                         gap = bodies.nodal("contact_normal_gap");
  CHECK(bodies.force_on(1).z() == Approx(10.0));
  CHECK(bodies.force_on(2).z() == Approx(-10.0));
  for (Eigen::Index i = 0; i < 4; ++i) {
    CHECK(area(0, i) == Approx(0.5));
    CHECK(force.col(i).norm() < 1e-12);
    CHECK(gap(0, i) == Approx(-0.01));
  }
}
