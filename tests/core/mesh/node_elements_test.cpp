// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/node_elements.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

namespace {

std::vector<std::uint32_t> elements_at(const NodeElements& elements, std::uint32_t node) {
  std::vector<std::uint32_t> places;
  for (const ElementIndex element : elements.of({node})) places.push_back(element.value);
  return places;
}

using AtNode = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a node tells its elements of all blocks, ascending", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  builder.add_bars({.id = 2, .from = {1, 0, 0}, .to = {5, 0, 0}});
  builder.add_node({9, 9, 9});
  const Mesh mesh = builder.build();
  const NodeElements elements(mesh);
  CHECK(elements_at(elements, 0) == AtNode{0});
  CHECK(elements_at(elements, 1) == AtNode{0, 1, 2});
  CHECK(elements_at(elements, 2) == AtNode{1});
  CHECK(elements_at(elements, 12) == AtNode{2});
  CHECK(elements_at(elements, 13).empty());
  std::size_t n = 0;
  for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) n += elements.of({node}).size();
  CHECK(n == 2 * 8 + 2);
}

TEST_CASE("an element that names a node twice is reported once", "[core][mesh]") {
  MeshBuilder builder;
  for (int i = 0; i < 6; ++i) builder.add_node({double(i), 0, 0});
  builder.add_block(1, "", Shape::hex8, {0, 1, 2, 2, 3, 4, 5, 5});
  const Mesh mesh = builder.build();
  const NodeElements elements(mesh);
  for (std::uint32_t node = 0; node < 6; ++node) CHECK(elements_at(elements, node) == AtNode{0});
}

TEST_CASE("elements of unknown types have no nodes", "[core][mesh]") {
  MeshParts parts = MeshBuilder().add_hexes({.id = 1}).add_hexes({.id = 2, .origin = {1, 0, 0}}).parts();
  parts.blocks[0].shape = Shape::unknown;
  parts.blocks[0].nodes.clear();
  const Mesh mesh(std::move(parts));
  const NodeElements elements(mesh);
  CHECK(elements_at(elements, 0).empty());
  CHECK(elements_at(elements, 1) == AtNode{1});
}
