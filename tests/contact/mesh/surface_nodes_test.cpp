// SPDX-License-Identifier: BSD-3-Clause
// What the nodes of contact surfaces stand for: area, thickness behind it, a face that has them.
#include "contact/mesh/surface_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/plate_and_tet.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Where a surface node is.
Vector3d place_of(const ContactParts& parts, const ContactMesh& contact_mesh, const SurfaceNode& node) {
  return parts.mesh.coordinates().col(contact_mesh.mesh_nodes[node.node].value);
}

}  // namespace

TEST_CASE("the nodes of a surface share its area", "[contact][contact_mesh]") {
  const ContactParts parts(plate_and_tet(), general_contact("", plate_and_tet_surfaces));
  double total = 0.0;
  for (std::uint32_t i = 0; i < 16; ++i) {
    const SurfaceNode& node = parts.contact_mesh.surface_nodes[{i}];
    const Eigen::Vector3d x = parts.mesh.coordinates().col(parts.contact_mesh.mesh_nodes[node.node].value);
    const bool at_x = x.x() == 0.0 || x.x() == 3.0, at_y = x.y() == 0.0 || x.y() == 3.0;
    CHECK(node.area == Approx(at_x && at_y ? 0.25 : at_x || at_y ? 0.5 : 1.0));
    CHECK(node.penalty_properties.thickness == Approx(0.5));
    total += node.area;
  }
  CHECK(total == Approx(9.0));
  for (std::uint32_t i = 16; i < 19; ++i)
    CHECK(parts.contact_mesh.surface_nodes[{i}].area == Approx(0.5 / 3.0));
}

TEST_CASE("a node of a set that has no face all in the set takes its share of all its outside faces",
          "[contact][contact_mesh]") {
  const ContactParts parts(plate_and_tet(), general_contact("", plate_and_tet_surfaces));
  // Faces at x = 0 are all in the set; the tip of the tetrahedron is a corner of three of its faces.
  const SurfaceNode& tip = parts.contact_mesh.surface_nodes.back();
  CHECK(parts.mesh.coordinates()(2, parts.contact_mesh.mesh_nodes[tip.node].value) == 3.0);
  CHECK(tip.area == Approx((1.5 + 1.5 + 0.5 * std::sqrt(19.0)) / 3.0));
  double at_side = 0.0;
  for (std::uint32_t i = 19; i < 27; ++i) at_side += parts.contact_mesh.surface_nodes[{i}].area;
  CHECK(at_side == Approx(1.5));
}

TEST_CASE("the thickness behind a node is the mean of its faces by area", "[contact][contact_mesh]") {
  // Two cells along x, 1 and 3 wide, of one height; the skin of their top alone.
  MeshBuilder b;
  b.add_hexes({.id = 1, .size = {1, 1, 2}});
  b.add_hexes({.id = 2, .origin = {1, 0, 0}, .size = {3, 1, 2}});
  b.add_side_set(1, "top", [](const CandidateSide& c) { return c.centroid.z() == 2.0; });
  b.add_side_set(2, "end", [](const CandidateSide& c) { return c.centroid.x() == 4.0; });
  const ContactParts parts(b, general_contact("", "contact surface s contains top end\n"));
  const ContactMesh& contact_mesh = parts.contact_mesh;
  REQUIRE(contact_mesh.surface_nodes.size() == 8);
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    const Vector3d x = place_of(parts, contact_mesh, node);
    // Quarters of faces of 1, 3, and 2 at the end, which is 3 thick.
    const double top = x.z() < 2.0 ? 0.0 : x.x() == 0.0 ? 0.25 : x.x() == 1.0 ? 1.0 : 0.75;
    const double end = x.x() == 4.0 ? 0.5 : 0.0;
    CHECK(node.area == Approx(top + end));
    CHECK(node.penalty_properties.thickness == Approx((2.0 * top + 3.0 * end) / (top + end)));
    const auto sides = parts.mesh.side_nodes(node.side);
    CHECK(std::ranges::count(sides, contact_mesh.mesh_nodes[node.node]) == 1);
  }
}

TEST_CASE("a set inside of a solid, or of lines, has nodes that stand for their masses",
          "[contact][contact_mesh]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .size = {2, 2, 2}});
  b.add_bars({.id = 2, .cells = 2, .from = {5, 0, 0}, .to = {7, 0, 0}});
  b.add_node_set(1, "inside", [](const Vector3d& x) { return x == Vector3d(1, 1, 1) || x.x() >= 5.0; });
  b.add_hexes({.id = 3, .origin = {20, 0, 0}});
  b.set_attributes(2, {"area"}, {0.1, 0.1});
  const ContactParts parts(b, general_contact("",
                                              "contact node set n contains inside\n"
                                              "contact surface s contains block_3\n"));
  const auto rows = parts.contact_mesh.rows_of({0});
  REQUIRE(rows.size() == 4);
  for (const SurfaceNodeIndex row : rows) {
    const SurfaceNode& node = parts.contact_mesh.surface_nodes[row];
    CHECK(node.area == 0.0);
    CHECK(std::isnan(node.penalty_properties.thickness));
    const auto nodes = parts.mesh.element_nodes(node.side.element());
    CHECK(std::ranges::count(nodes, parts.contact_mesh.mesh_nodes[node.node]) == 1);
  }
  // The first of the elements that have a node.
  CHECK(parts.contact_mesh.surface_nodes[*rows.begin()].side.element() == ElementIndex{0});
}

TEST_CASE("free nodes stand among the others, for their share of a face of a dead element",
          "[contact][contact_mesh]") {
  MeshBuilder b = plate_and_tet();
  const ContactParts parts(b, general_contact("", plate_and_tet_surfaces));
  // The tetrahedron has died: the top and the tip of a plate's corner are of the surfaces a and n.
  const ElementSide floor = parts.contact_mesh.faces[{9}].side, top = parts.contact_mesh.faces[{0}].side;
  const NodeIndex corner = parts.contact_mesh.mesh_nodes[parts.contact_mesh.faces[{9}].corners[0]];
  const std::vector<ErodedNode> eroded{{corner, {0}, floor}, {corner, {2}, top}};
  const ContactMesh contact_mesh = make_contact_mesh(parts.model, parts.mesh, eroded);
  REQUIRE(contact_mesh.surface_nodes.size() == parts.contact_mesh.surface_nodes.size() + 2);
  CHECK(contact_mesh.faces.size() == parts.contact_mesh.faces.size());
  std::size_t n_free = 0;
  for (const SurfaceIndex surface : contact_mesh.surfaces()) {
    ContactNodeIndex last{0};
    for (const SurfaceNodeIndex row : contact_mesh.rows_of(surface)) {
      const SurfaceNode& node = contact_mesh.surface_nodes[row];
      CHECK(node.surface == surface);
      CHECK(node.node >= last);
      last = node.node;
      if (!node.is_free) continue;
      ++n_free;
      CHECK(contact_mesh.mesh_nodes[node.node] == corner);
      if (surface == SurfaceIndex{0}) {
        CHECK(node.area == Approx(0.5 / 3.0));
        CHECK(node.penalty_properties.thickness == Approx(1.0));
        CHECK(node.side == floor);
      } else {
        CHECK(surface == SurfaceIndex{2});
        CHECK(node.area == 0.0);  // of a set: by its mass
        CHECK(std::isnan(node.penalty_properties.thickness));
      }
    }
  }
  CHECK(n_free == 2);
}

TEST_CASE("contact numbers are those of the mesh's nodes that are in contact", "[contact][contact_mesh]") {
  const ContactParts parts(plate_and_tet(), general_contact("", plate_and_tet_surfaces));
  const ContactNumbers numbers(parts.mesh, parts.contact_mesh);
  CHECK(numbers.n_nodes() == parts.contact_mesh.n_nodes());
  for (const ContactNodeIndex i : parts.contact_mesh.nodes())
    CHECK(numbers[parts.contact_mesh.mesh_nodes[i]] == i);
}
