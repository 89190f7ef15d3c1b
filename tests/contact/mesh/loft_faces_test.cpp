// SPDX-License-Identifier: BSD-3-Clause
// What contact surfaces have of lofts: faces and nodes of bricks, capsules, spheres.
#include "contact/mesh/loft_faces.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A rod of two elements with the given radii, 1 and 2 long, along x.
MeshBuilder rods_of(double first, double second) {
  MeshBuilder b;
  b.add_beams({.id = 1, .from = {0, 0, 0}, .to = {1, 0, 0}});
  b.set_attributes(1, {"area"}, {first * first * std::numbers::pi});
  b.add_beams({.id = 2, .from = {1, 0, 0}, .to = {3, 0, 0}});
  return b.set_attributes(2, {"area"}, {second * second * std::numbers::pi});
}

}  // namespace

TEST_CASE("a plate has the faces of its brick, whose nodes share their area", "[contact][loft_faces]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .u = {2, 0, 0}, .v = {0, 3, 0}}, 0.2);
  const ContactParts parts(b, general_contact("self contact = on\n"));
  const ContactMesh& contact_mesh = parts.contact_mesh;
  REQUIRE(contact_mesh.faces.size() == 6);
  REQUIRE(contact_mesh.surface_nodes.size() == 8);
  CHECK(contact_mesh.n_mesh_points() == 0);
  CHECK(contact_mesh.loft.size() == 8);
  for (const ContactFace& face : contact_mesh.faces) {
    CHECK(contact_mesh.is_lofted(face));
    CHECK(face.penalty_properties.thickness == 0.2);
    CHECK(face.side.element() == ElementIndex{0});
  }
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    // A quarter each of faces of 2 x 3, 2 x 0.2 and 3 x 0.2.
    CHECK(node.area == Approx(0.25 * (6.0 + 0.4 + 0.6)));
    CHECK(node.radius == 0.0f);
    CHECK(node.penalty_properties.thickness == 0.2);
  }
  for (const ContactNodeIndex i : contact_mesh.nodes()) {
    // Two points hang on each node, the first of which both are alike to.
    std::size_t n_alike = 0;
    for (const ContactNodeIndex k : contact_mesh.nodes())
      n_alike += contact_mesh.first_alike[k] == contact_mesh.first_alike[i] ? 1 : 0;
    CHECK(n_alike == 2);
    CHECK(contact_mesh.first_alike[i] <= i);
    CHECK(contact_mesh.mesh_nodes[contact_mesh.first_alike[i]] == contact_mesh.mesh_nodes[i]);
  }
}

TEST_CASE("points of lofts on a node that a solid has are alike to it", "[contact][loft_faces]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  add_plate(b, {.id = 2, .origin = {1, 0, 0}, .u = {1, 0, 0}, .v = {0, 1, 0}}, 0.2);  // beside its bottom
  const ContactParts parts(b, general_contact());
  const ContactMesh& contact_mesh = parts.contact_mesh;
  CHECK(contact_mesh.n_mesh_points() == 8);
  CHECK(contact_mesh.n_nodes() == 16);
  std::size_t n_of_solid = 0;
  for (const ContactNodeIndex i : contact_mesh.nodes()) {
    if (contact_mesh.is_mesh_point(i)) {
      CHECK(contact_mesh.first_alike[i] == i);
      continue;
    }
    const bool is_of_solid = parts.mesh.coordinates()(0, contact_mesh.mesh_nodes[i].value) == 1.0;
    CHECK(contact_mesh.is_mesh_point(contact_mesh.first_alike[i]) == is_of_solid);
    n_of_solid += is_of_solid ? 1 : 0;
  }
  CHECK(n_of_solid == 4);
  for (const ContactFace& face : contact_mesh.faces)
    CHECK(contact_mesh.is_lofted(face) == (face.surface == SurfaceIndex{1}));
}

TEST_CASE("a rod is a capsule with spheres at its ends, by the least radius there", "[contact][loft_faces]") {
  const bool is_first_thick = GENERATE(false, true);
  const double first = is_first_thick ? 0.2 : 0.1, second = is_first_thick ? 0.1 : 0.2;
  const ContactParts parts(rods_of(first, second), general_contact());
  const ContactMesh& contact_mesh = parts.contact_mesh;
  REQUIRE(contact_mesh.edges.size() == 2);
  CHECK(contact_mesh.faces.empty());
  for (const EdgeIndex i : indices(contact_mesh.edges)) {
    const ContactEdge& edge = contact_mesh.edges[i];
    const double radius = i == EdgeIndex{0} ? first : second;
    CHECK(edge.surface == SurfaceIndex{i.value});
    CHECK(edge.radius == Approx(radius));
    CHECK(edge.width == Approx(2.0 * radius));
    CHECK(edge.penalty_properties.thickness == Approx(0.5 * std::numbers::pi * radius));
    // The joint is the second end of the first and the first end of the second.
    CHECK(edge.less[1 - i.value] == Approx(radius - 0.1).margin(1e-15));
    CHECK(edge.less[i.value] == Approx(0.0).margin(1e-15));
    CHECK_FALSE(edge.is_sharp());
    CHECK_FALSE(edge.is_particle());
  }
  REQUIRE(contact_mesh.surface_nodes.size() == 4);  // the joint is a node of both
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    const double x = parts.kinematics.x(node.node).x(), of = node.surface == SurfaceIndex{0} ? first : second;
    CHECK(node.radius == Approx(x == 1.0 ? 0.1 : of));
    CHECK(node.area == Approx(of * (node.surface == SurfaceIndex{0} ? 1.0 : 2.0)));
  }
  const std::vector<double> radii = least_radii(parts.model, parts.mesh);
  REQUIRE(radii.size() == 3);
  CHECK(radii[0] == Approx(first));
  CHECK(radii[1] == Approx(0.1));
  CHECK(radii[2] == Approx(second));
}

TEST_CASE("a particle is a node with a radius and an edge of one node", "[contact][loft_faces]") {
  MeshBuilder b;
  add_balls(b, 1, {{0, 0, 0}, {3, 0, 0}}, 0.3);
  const ContactParts parts(b, general_contact("self contact = on\n"));
  const ContactMesh& contact_mesh = parts.contact_mesh;
  REQUIRE(contact_mesh.surface_nodes.size() == 2);
  REQUIRE(contact_mesh.edges.size() == 2);
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    CHECK(node.radius == Approx(0.3));
    CHECK(node.area == Approx(std::numbers::pi * 0.09));
    CHECK(node.penalty_properties.thickness == Approx(0.4));  // 4/3 pi r^3 over pi r^2
  }
  for (const ContactEdge& edge : contact_mesh.edges) {
    CHECK(edge.is_particle());
    CHECK(edge.radius == Approx(0.3));
    CHECK(edge.width == Approx(0.6));
    CHECK(edge.penalty_properties.thickness == Approx(0.4));
  }
  CHECK(least_radii(parts.model, parts.mesh).empty());  // there are no rods
}
