// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_mesh.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/plate_and_tet.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("contact numbers the nodes of its surfaces alone, in the order of the mesh",
          "[contact][contact_mesh]") {
  const ContactParts parts(plate_and_tet(), general_contact("", plate_and_tet_surfaces));
  const ContactMesh& contact_mesh = parts.contact_mesh;
  // 16 of the top, 3 of the floor, 8 at x = 0 of which 4 are of the top, one tip.
  CHECK(contact_mesh.n_nodes() == 16 + 3 + 4 + 1);
  CHECK(std::is_sorted(contact_mesh.mesh_nodes.begin(), contact_mesh.mesh_nodes.end()));
  REQUIRE(contact_mesh.faces.size() == 10);
  CHECK(contact_mesh.first_face == std::vector<FaceIndex>{{0}, {9}, {10}, {10}});
  for (const ContactFace& face : contact_mesh.faces) {
    const auto nodes = parts.mesh.side_nodes(face.side);
    for (std::size_t k = 0; k < 4; ++k) CHECK(contact_mesh.mesh_nodes[face.corners[k]] == nodes[k]);
    CHECK(face.is_triangle() == (face.surface == SurfaceIndex{1}));
  }
  CHECK(contact_mesh.first_node == std::vector<SurfaceNodeIndex>{{0}, {16}, {19}, {28}});
}

TEST_CASE("behind a face is its element: volume over area", "[contact][contact_mesh]") {
  const ContactParts parts(plate_and_tet(), general_contact("", plate_and_tet_surfaces));
  for (const ContactFace& face : parts.contact_mesh.faces)
    CHECK(face.penalty_properties.thickness == Approx(face.is_triangle() ? 1.0 : 0.5));
}

TEST_CASE("a six-node face is one row of ownership and four facets of contact, which all nodes carry",
          "[contact][contact_mesh]") {
  MeshBuilder b;
  b.add_ten_node_tets({.id = 1, .cells = {1, 1, 1}});
  b.add_side_set(1, "top", [](const CandidateSide& c) { return c.centroid.z() > 0.99; });
  const ContactParts parts(b, general_contact("", "contact surface a contains top\n"));
  const ContactMesh& contact_mesh = parts.contact_mesh;
  CHECK(parts.model.surfaces.surfaces[{0}].faces.size() == 2);
  REQUIRE(contact_mesh.faces.size() == 8);
  CHECK(contact_mesh.n_nodes() == 9);
  double total = 0.0;
  for (const SurfaceNode& node : contact_mesh.surface_nodes) total += node.area;
  CHECK(total == Approx(1.0));
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    const Eigen::Vector3d x = parts.mesh.coordinates().col(contact_mesh.mesh_nodes[node.node].value);
    const bool is_corner = x.x() != 0.5 && x.y() != 0.5, is_between = x.x() == 0.5 && x.y() == 0.5;
    const auto n_facets = static_cast<double>(contact_mesh.faces_of_node.of(node.node).size());
    CHECK(node.area == Approx(n_facets / 24.0));  // facets of 1/8, a third of each
    CHECK(n_facets == (is_between ? 6 : is_corner ? (x.x() == x.y() ? 2 : 1) : 3));
  }
  for (const FaceIndex f : indices(contact_mesh.faces)) {
    CHECK(contact_mesh.faces[f].is_triangle());
    CHECK(contact_mesh.faces[f].side == contact_mesh.faces[{f.value / 4 * 4}].side);
    CHECK(contact_mesh.faces[f].penalty_properties.thickness == Approx(1.0 / 3.0));
  }
}

TEST_CASE("a node knows the faces that have it", "[contact][contact_mesh]") {
  const ContactParts parts(plate_and_tet(), general_contact("", plate_and_tet_surfaces));
  const ContactMesh& contact_mesh = parts.contact_mesh;
  REQUIRE(contact_mesh.faces_of_node.n_rows() == contact_mesh.n_nodes());
  for (const ContactNodeIndex node : contact_mesh.nodes()) {
    std::vector<FaceIndex> slow;
    for (const FaceIndex f : indices(contact_mesh.faces)) {
      const auto& corners = contact_mesh.faces[f].corners;
      if (std::count(corners.begin(), corners.end(), node) > 0) slow.push_back(f);
    }
    const auto fast = contact_mesh.faces_of_node.of(node);
    CHECK(std::ranges::equal(fast, slow));
  }
  CHECK(contact_mesh.share_node(contact_mesh.faces[{0}], contact_mesh.faces[{1}]));
  CHECK(contact_mesh.share_node(contact_mesh.faces[{0}], contact_mesh.faces[{4}]));
  CHECK(!contact_mesh.share_node(contact_mesh.faces[{0}], contact_mesh.faces[{2}]));
  CHECK(!contact_mesh.share_node(contact_mesh.faces[{0}], contact_mesh.faces[{9}]));
}

TEST_CASE("nodes of a set that no outside face has stand for a cube of their mass",
          "[contact][contact_mesh]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .size = {2, 2, 2}});
  b.add_node_set(1, "all", [](const Eigen::Vector3d&) { return true; });
  b.add_hexes({.id = 2, .origin = {5, 0, 0}});
  b.add_spheres(3, "", {{9, 0, 0}});
  b.set_attributes(3, {"radius"}, {0.25});
  const ContactBodies bodies(
      b,
      general_contact("", "contact node set n contains all block_3\ncontact surface s contains block_2\n"));
  const ContactMesh& contact_mesh = bodies.contact.contact_mesh();
  CHECK(contact_mesh.rows_of({0}).size() == 28);
  const auto area_of = [&](std::uint32_t row) { return contact_mesh.surface_nodes[{row}].area; };
  const double volume = contact_mesh.mass[contact_mesh.surface_nodes[{13}].node];  // the density is 1
  CHECK(area_of(13) == Approx(std::pow(volume, 2.0 / 3.0)));
  CHECK(area_of(12) == Approx(1.0));
  CHECK(area_of(27) == Approx(std::pow(contact_mesh.mass[contact_mesh.surface_nodes[{27}].node], 2.0 / 3.0)));
}

TEST_CASE("what stands behind faces is as stiff and as heavy as its material", "[contact][contact_mesh]") {
  const ContactBodies bodies(plate_and_tet(), general_contact("", plate_and_tet_surfaces));
  ContactMesh contact_mesh = make_contact_mesh(bodies.definition, bodies.mesh);
  add_penalty_properties(bodies.model, contact_mesh);
  CHECK(contact_mesh.faces[{0}].penalty_properties.mass_per_area == Approx(0.5 * 0.5));
  CHECK(contact_mesh.faces[{0}].penalty_properties.stiffness == Approx(penalty_over_element / 0.5));
  CHECK(contact_mesh.faces[{9}].penalty_properties.stiffness == Approx(penalty_over_element));
  REQUIRE(contact_mesh.mass.size() == contact_mesh.n_nodes());
  // A corner of the plate has an eighth of a cell of volume 0.5.
  CHECK(*std::min_element(contact_mesh.mass.begin(), contact_mesh.mass.end()) == Approx(0.5 / 8));
}
