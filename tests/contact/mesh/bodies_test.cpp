// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/bodies.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("elements that share a node are one body, by its first node", "[contact][bodies]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {3, 0, 0}});
  b.add_hexes({.id = 3, .origin = {1, 1, 1}});   // at a corner of the first
  b.add_shells({.id = 4, .origin = {4, 0, 0}});  // along an edge of the second
  const Mesh mesh = b.build();
  const auto bodies = find_bodies(mesh);
  REQUIRE(bodies.size() == mesh.n_nodes());
  for (const ElementBlock& block : mesh.blocks()) {
    const std::uint32_t first = block.id == 1 || block.id == 3 ? 0 : 8;
    for (const NodeIndex node : block.nodes) CHECK(bodies[node.value] == first);
  }
}

TEST_CASE("a body is found whatever the order of its elements", "[contact][bodies]") {
  // A row of shells whose neighbours are far apart in the list.
  const std::vector<std::uint32_t> order =
      GENERATE(std::vector<std::uint32_t>{0, 2, 4, 1, 3}, std::vector<std::uint32_t>{4, 3, 2, 1, 0},
               std::vector<std::uint32_t>{2, 0, 3, 1, 4});
  MeshBuilder b;
  for (std::uint32_t i = 0; i < 6; ++i) {
    b.add_node({double(i), 0, 0});
    b.add_node({double(i), 1, 0});
  }
  std::vector<std::uint32_t> nodes;
  for (const std::uint32_t i : order) nodes.insert(nodes.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  b.add_block(1, "", Shape::shell4, nodes);
  CHECK(find_bodies(b.build()) == std::vector<std::uint32_t>(12, 0));
}

TEST_CASE("lines and particles join nothing, and nodes alone are bodies", "[contact][bodies]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {3, 0, 0}});
  b.add_bars({.id = 3, .from = {1, 0, 0}, .to = {3, 0, 0}});
  b.add_spheres(4, "", {{0, 0, 9}});
  b.add_node({0, 0, 20});
  const auto bodies = find_bodies(b.build());
  CHECK(bodies[0] == 0);
  CHECK(bodies[8] == 8);
  CHECK(bodies[16] == 16);
  CHECK(bodies[17] == 17);
}
