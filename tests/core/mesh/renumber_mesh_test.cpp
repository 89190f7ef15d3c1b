// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/renumber_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "core/mesh/mesh_digest.hpp"
#include "core/mesh/mesh_parts.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/slow_skin.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two blocks of other sizes with a side set, a node set and attributes, and a node of no element.
MeshParts two_blocks() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {5, 4, 3}});
  b.add_hexes({.id = 2, .cells = {2, 6, 2}, .origin = {7, 0, 0}, .share_nodes = false});
  b.add_side_set(1, "tops", [](const CandidateSide& side) { return side.normal.z() > 0.9; });
  b.add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; });
  MeshParts parts = b.parts();
  parts.blocks[0].attribute_names = {"a", "b"};
  for (std::uint32_t i = 0; i < 2 * parts.blocks[0].n_elements; ++i)
    parts.blocks[0].attributes.push_back(0.5 * i);
  parts.coordinates.conservativeResize(3, parts.coordinates.cols() + 1);
  parts.coordinates.rightCols<1>() = Eigen::Vector3d(0.1, 0.2, 9.0);
  return parts;
}

/// The same mesh, its nodes and the elements of each block in another order; ids stay with them.
Mesh shuffled(const Mesh& mesh) {
  std::mt19937 random(7);
  MeshParts parts = parts_of(mesh);
  std::vector<std::uint32_t> node(mesh.n_nodes());
  std::iota(node.begin(), node.end(), 0u);
  std::ranges::shuffle(node, random);  // where each goes
  for (std::uint32_t i = 0; i < node.size(); ++i) {
    parts.coordinates.col(node[i]) = mesh.coordinates().col(i);
    parts.node_ids[node[i]] = mesh.node_id({i});
  }
  for (NodeSet& set : parts.node_sets) {
    for (NodeIndex& member : set.nodes) member.value = node[member.value];
  }
  std::vector<std::uint32_t> element(mesh.n_elements());
  for (ElementBlock& own : parts.blocks) {
    const ElementBlock before = own;
    std::vector<std::uint32_t> order(own.n_elements);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::shuffle(order, random);
    for (std::uint32_t i = 0; i < own.n_elements; ++i) {
      for (std::size_t k = 0; k < 8; ++k)
        own.nodes[8 * order[i] + k] = {node[before.element_nodes(i)[k].value]};
      for (std::size_t k = 0; k < before.attribute_names.size(); ++k)
        own.attributes[2 * order[i] + k] = before.attributes[2 * i + k];
      const std::uint32_t first = own.first_element.value;
      element[first + i] = first + order[i];
      parts.element_ids[first + order[i]] = mesh.element_id({first + i});
    }
  }
  for (SideSet& set : parts.side_sets) {
    for (ElementSide& side : set.sides) side = ElementSide({element[side.element().value]}, side.side());
  }
  parts.node_places.clear();
  parts.element_places.clear();
  return Mesh(std::move(parts));
}

std::size_t n_nodes_of(const ElementBlock& of, std::uint32_t first, std::uint32_t n) {
  std::set<NodeIndex> nodes;
  for (std::uint32_t i = first; i < first + n; ++i)
    nodes.insert(of.element_nodes(i).begin(), of.element_nodes(i).end());
  return nodes.size();
}

/// The nodes of faces that an odd number of solids have, and all of elements that are no solids.
std::set<NodeIndex> slow_surface_nodes(const Mesh& mesh) {
  const auto is_solid = [&](ElementIndex element) {
    return topology(mesh.blocks()[mesh.block_of(element)].shape).family == Family::solid;
  };
  std::set<NodeIndex> nodes;
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) {
    if (!is_solid({i})) nodes.insert(mesh.element_nodes({i}).begin(), mesh.element_nodes({i}).end());
  }
  const std::vector<std::uint8_t> present(mesh.n_elements(), 1);
  for (const auto& [corners, sides] : group_faces(mesh, present)) {
    std::vector<ElementSide> of_solids;
    std::ranges::copy_if(sides, std::back_inserter(of_solids),
                         [&](ElementSide side) { return is_solid(side.element()); });
    if (of_solids.size() % 2 == 0) continue;
    for (const auto& facet : mesh.side_facets(of_solids.front())) nodes.insert(facet.begin(), facet.end());
  }
  return nodes;
}

}  // namespace

TEST_CASE("neighbours on Hilbert's curve share a side", "[core][mesh]") {
  // Eight cells along each axis: the three highest bits.
  constexpr std::uint32_t n = 8, size = (1u << hilbert_bits) / n;
  std::vector<std::pair<std::uint64_t, std::array<int, 3>>> cells;
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      for (int z = 0; z < 8; ++z) {
        const auto along = [&](int i) { return static_cast<std::uint32_t>(i) * size; };
        cells.push_back({hilbert_place({along(x), along(y), along(z)}), {x, y, z}});
      }
    }
  }
  std::ranges::sort(cells);
  CHECK(cells.front().second == std::array{0, 0, 0});
  for (std::size_t i = 1; i < cells.size(); ++i) {
    int steps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      steps += std::abs(cells[i].second[axis] - cells[i - 1].second[axis]);
    REQUIRE(steps == 1);
  }
}

TEST_CASE("a renumbered mesh is the same mesh, and knows the order of its file", "[core][mesh]") {
  const Mesh mesh(two_blocks()), renumbered = renumber_mesh(mesh);
  REQUIRE(renumbered.n_nodes() == mesh.n_nodes());
  REQUIRE(renumbered.n_elements() == mesh.n_elements());
  const auto before = [&](NodeIndex node) { return NodeIndex{renumbered.node_place(node)}; };
  std::vector<std::uint8_t> is_taken(mesh.n_nodes(), 0);
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
    const NodeIndex was = before({i});
    CHECK(++is_taken[was.value] == 1);
    CHECK(renumbered.node_id({i}) == mesh.node_id(was));
    CHECK(renumbered.coordinates().col(i) == mesh.coordinates().col(was.value));
    CHECK(renumbered.find_node(mesh.node_id(was)) == NodeIndex{i});
  }
  CHECK(before({mesh.n_nodes() - 1}).value == mesh.n_nodes() - 1);  // of no element
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) {
    const ElementIndex was{renumbered.element_place({i})};
    CHECK(renumbered.block_of({i}) == mesh.block_of(was));
    CHECK(renumbered.find_element(mesh.element_id(was)) == ElementIndex{i});
    const auto now = renumbered.element_nodes({i}), old = mesh.element_nodes(was);
    for (std::size_t k = 0; k < 8; ++k) CHECK(before(now[k]) == old[k]);
    if (i < mesh.blocks()[0].n_elements) {
      for (std::size_t k = 0; k < 2; ++k)
        CHECK(renumbered.blocks()[0].attributes[2 * i + k] == mesh.blocks()[0].attributes[2 * was.value + k]);
    }
  }
  const auto &sides = mesh.side_sets()[0].sides, &sides_now = renumbered.side_sets()[0].sides;
  REQUIRE(sides_now.size() == sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    CHECK(renumbered.element_place(sides_now[i].element()) == sides[i].element().value);
    CHECK(sides_now[i].side() == sides[i].side());
  }
  const auto &nodes = mesh.node_sets()[0].nodes, &nodes_now = renumbered.node_sets()[0].nodes;
  REQUIRE(nodes_now.size() == nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) CHECK(before(nodes_now[i]) == nodes[i]);
}

TEST_CASE("a renumbered mesh without id maps keeps none, and finds what the file counts", "[core][mesh]") {
  const Mesh mesh(two_blocks());
  Mesh renumbered = renumber_mesh(mesh);
  bool is_in_order = true;
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) is_in_order &= renumbered.node_place({i}) == i;
  REQUIRE_FALSE(is_in_order);
  const MeshParts parts = Mesh(renumbered).release();
  CHECK(parts.node_ids.empty());
  CHECK(parts.element_ids.empty());
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
    CHECK(renumbered.node_id({i}) == renumbered.node_place({i}) + 1);
    CHECK(renumbered.find_node(renumbered.node_id({i})) == NodeIndex{i});
  }
  for (const std::int64_t absent : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{mesh.n_nodes()} + 1}) {
    CHECK(!renumbered.find_node(absent));
    CHECK(!renumbered.find_element(absent));
  }
  // Nodes beyond those that have a place in the file stand where they are.
  MeshParts more = parts_of(renumbered);
  more.coordinates.conservativeResize(3, more.coordinates.cols() + 1);
  more.coordinates.rightCols<1>().setZero();
  more.node_ids.push_back(mesh.n_nodes() + 1);
  const Mesh longer(more);
  CHECK(longer.node_id({mesh.n_nodes()}) == mesh.n_nodes() + 1);
  CHECK(longer.find_node(mesh.n_nodes() + 1) == NodeIndex{mesh.n_nodes()});
  CHECK(std::move(renumbered).release().node_places == parts.node_places);
}

TEST_CASE("ids of a map stay with what is renumbered, also those that count in another order",
          "[core][mesh]") {
  MeshParts parts = two_blocks();
  const auto n_nodes = static_cast<std::uint32_t>(parts.coordinates.cols());
  for (std::uint32_t i = 0; i < n_nodes; ++i) parts.node_ids.push_back(n_nodes - i);
  const Mesh renumbered = renumber_mesh(Mesh(parts));
  for (std::uint32_t i = 0; i < n_nodes; ++i) {
    CHECK(renumbered.node_id({i}) == n_nodes - renumbered.node_place({i}));
    CHECK(renumbered.find_node(n_nodes - renumbered.node_place({i})) == NodeIndex{i});
  }
}

TEST_CASE("a mesh in another order is renumbered to the same one", "[core][mesh]") {
  const Mesh mesh(two_blocks()), other = shuffled(mesh);
  REQUIRE(digest_of(other) != digest_of(mesh));
  const Mesh renumbered = renumber_mesh(mesh), again = renumber_mesh(other);
  CHECK(digest_of(again) == digest_of(renumbered));
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i)
    CHECK(again.element_id({i}) == renumbered.element_id({i}));
  // What is renumbered is in order, and still knows its file.
  const Mesh twice = renumber_mesh(again);
  CHECK(digest_of(twice) == digest_of(again));
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) CHECK(twice.node_place({i}) == again.node_place({i}));
}

TEST_CASE("512 elements that follow each other are a cube", "[core][mesh]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {32, 16, 16}, .size = {32, 16, 16}});
  const Mesh mesh = renumber_mesh(b.build());
  for (std::uint32_t first = 0; first < mesh.n_elements(); first += 512)
    CHECK(n_nodes_of(mesh.blocks()[0], first, 512) == 9 * 9 * 9);
}

TEST_CASE("nodes of surfaces come before those inside, block by block", "[core][mesh]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {5, 4, 6}, .size = {5, 4, 6}});
  b.add_hexes({.id = 2, .cells = {3, 4, 6}, .origin = {5, 0, 0}, .size = {3, 4, 6}});  // joined
  std::uint32_t n_inside = 7 * 3 * 5;
  SECTION("hexahedra") {}
  SECTION("wedges, a shell through hexahedra, a bar in a node inside") {
    b.add_wedges({.id = 3, .cells = {2, 2, 2}, .origin = {0, 9, 0}});
    b.add_shells({.id = 4, .cells = {2, 1}, .origin = {1, 1, 2}, .u = {2, 0, 0}, .v = {0, 1, 0}});
    b.add_bars({.id = 5, .from = {6, 2, 2}, .to = {6, 2, 9}});
    n_inside += 1 - 6 - 1;
  }
  SECTION("tetrahedra of ten nodes and pyramids") {
    b.add_ten_node_tets({.id = 3, .cells = {2, 2, 2}, .origin = {0, 9, 0}});
    b.add_pyramids({.id = 4, .cells = {1, 1, 2}, .origin = {0, 11, 0}});
    // 5^3 nodes and midside nodes in all of 3^3; two apexes of pyramids.
    n_inside += 3 * 3 * 3 + 2;
  }
  const Mesh mesh = renumber_mesh(b.build());
  const std::set<NodeIndex> on_surface = slow_surface_nodes(mesh);
  std::uint32_t next = 0, inside = 0;
  for (const ElementBlock& block : mesh.blocks()) {
    for (const bool is_inside : {false, true}) {
      for (const NodeIndex node : block.nodes) {
        if (on_surface.contains(node) == is_inside) continue;
        REQUIRE(node.value <= next);  // as elements use them first
        if (node.value < next) continue;
        ++next;
        if (is_inside) ++inside;
      }
    }
  }
  CHECK(next == mesh.n_nodes());
  CHECK(inside == n_inside);
}

TEST_CASE("meshes without extent, elements or known shapes keep their order", "[core][mesh]") {
  CHECK(renumber_mesh(Mesh()).n_nodes() == 0);
  MeshParts flat;
  flat.coordinates = Eigen::Matrix3Xd::Zero(3, 3);
  ElementBlock points;
  points.id = 1;
  points.shape = Shape::sphere;
  points.n_elements = 3;
  points.nodes_per_element = 1;
  points.nodes = {{2}, {0}, {1}};
  flat.blocks.push_back(points);
  ElementBlock unknown;
  unknown.id = 2;
  unknown.n_elements = 4;
  unknown.nodes_per_element = 5;
  flat.blocks.push_back(unknown);
  const Mesh mesh = renumber_mesh(Mesh(flat));
  for (std::uint32_t i = 0; i < 7; ++i) CHECK(mesh.element_place({i}) == i);
  CHECK(mesh.node_place({0}) == 2);
  CHECK(mesh.node_id({0}) == 3);
}
