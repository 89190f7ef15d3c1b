// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/eroded_nodes.hpp"

#include <algorithm>

#include "contact/surfaces/surface_request.hpp"
#include "core/mesh/node_elements.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Elements that die one after another, and the nodes that this sets free.
struct DyingElements {
  Mesh mesh;
  NodeElements elements;
  FaceGroups faces;
  OwnershipRules rules;
  std::vector<std::uint8_t> alive;
  ErodedNodes eroded;

  DyingElements(const MeshBuilder& builder, const std::string& lines, std::vector<std::uint8_t> erodes = {})
      : mesh(builder.build()),
        elements(mesh),
        faces(mesh, elements),
        rules(make_rules(lines)),
        alive(mesh.n_elements(), 1),
        eroded(faces, erodes.empty() ? std::vector<std::uint8_t>(mesh.n_elements(), 0) : std::move(erodes)) {}
  OwnershipRules make_rules(const std::string& lines) const {
    Diagnostics diagnostics;
    const ContactDefinition contact = parse_contact(lines);
    return {make_surface_requests(contact, {}, mesh, diagnostics), mesh, contact.subdomain};
  }
  void kill(const std::vector<ElementIndex>& dead) {
    for (const ElementIndex element : dead) alive[element.value] = 0;
    eroded.add(rules, dead, alive);
  }
  /// The free nodes with their surfaces, in stored order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const ErodedNode& one : eroded.nodes()) pairs.emplace_back(one.node.value, one.surface.value);
    return pairs;
  }
};

using Found = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

const std::string skins = "skin all blocks = on\n";

/// Three unit cells along x: nodes 0 to 3, 4 to 7 and so on.
MeshBuilder three_cells() {
  return MeshBuilder().add_hexes({.id = 1, .cells = {3, 1, 1}, .size = {3, 1, 1}});
}

}  // namespace

TEST_CASE("nodes are free once all their elements are dead", "[contact][death]") {
  DyingElements cells(three_cells(), skins);
  cells.kill({{0}});
  CHECK(cells.found() == Found{{0, 0}, {4, 0}, {8, 0}, {12, 0}});
  cells.kill({{2}});
  CHECK(cells.found() == Found{{0, 0}, {3, 0}, {4, 0}, {7, 0}, {8, 0}, {11, 0}, {12, 0}, {15, 0}});
  cells.kill({{1}});
  CHECK(cells.eroded.nodes().size() == 16);
  CHECK(cells.eroded.n_nodes() == 16);
  CHECK(std::ranges::is_sorted(cells.eroded.nodes(), {}, &ErodedNode::node));
  for (const ErodedNode& one : cells.eroded.nodes()) {
    const auto nodes = cells.mesh.side_nodes(one.side);
    CHECK(std::ranges::count(nodes, one.node) == 1);  // it stands for a face that has it
  }
}

TEST_CASE("elements that take their nodes with them set none free but those of others", "[contact][death]") {
  DyingElements gone(three_cells(), skins, {1, 1, 1});
  gone.kill({{0}, {1}, {2}});
  CHECK(gone.found().empty());
  DyingElements some(three_cells(), skins, {1, 0, 1});
  some.kill({{0}, {1}, {2}});
  CHECK(some.eroded.n_nodes() == 8);  // those of the cell in the middle
  for (const ErodedNode& one : some.eroded.nodes()) {
    const double x = some.mesh.coordinates()(0, one.node.value);
    CHECK((x == 1.0 || x == 2.0));
  }
}

TEST_CASE("a free node is of the first surface that any face of its dead elements would be of",
          "[contact][death]") {
  MeshBuilder b;
  b.add_hexes({.id = 1}).add_hexes({.id = 2, .origin = {1, 0, 0}});
  DyingElements cells(b, "contact surface first contains block_2\ncontact surface second contains block_1\n");
  cells.kill({{0}, {1}});
  for (const ErodedNode& one : cells.eroded.nodes()) {
    const bool is_of_second = cells.mesh.coordinates()(0, one.node.value) == 0.0;
    CHECK(one.surface == SurfaceIndex{is_of_second ? 1u : 0u});
    CHECK(one.side.element() == ElementIndex{is_of_second ? 0u : 1u});
  }
  CHECK(cells.eroded.n_nodes() == 12);
}

TEST_CASE("shells leave no free nodes, elements of no surface neither", "[contact][death]") {
  MeshBuilder b;
  b.add_shells({.id = 1, .cells = {2, 1}});
  b.set_attributes(1, {"thickness"}, {0.1, 0.1});
  b.add_hexes({.id = 2, .origin = {0, 0, 5}});
  DyingElements elements(b, "contact surface s contains block_1\n");
  elements.kill({{0}, {1}, {2}});
  CHECK(elements.found().empty());
}

TEST_CASE("a node that its element gave to a set is of that surface too, but for sets of the mesh",
          "[contact][death]") {
  MeshBuilder b = three_cells();
  b.add_node_set(1, "left", [](const Vector3d& x) { return x.x() == 0.0; });
  // Of a block as a surface of nodes: alive it has them, dead no more. A node set has them always.
  DyingElements of_block(b, "skin all blocks = on\ncontact node set n contains block_1\n");
  of_block.kill({{0}});
  CHECK(of_block.eroded.n_nodes() == 4);
  CHECK(of_block.eroded.nodes().size() == 8);
  for (std::size_t i = 0; i < 8; i += 2) {
    CHECK(of_block.eroded.nodes()[i].node == of_block.eroded.nodes()[i + 1].node);
    CHECK(of_block.eroded.nodes()[i].surface != of_block.eroded.nodes()[i + 1].surface);
  }
  DyingElements of_set(b, "skin all blocks = on\ncontact node set n contains left\n");
  of_set.kill({{0}});
  CHECK(of_set.eroded.nodes().size() == 4);
}
