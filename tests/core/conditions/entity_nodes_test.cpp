// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_nodes.hpp"

#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes that share the nodes at x = 1 (1 3 5 7); node ids are positions + 1.
Mesh cubes_with_sets() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1, 0, 0}});
  b.add_side_set(10, "left", [](const CandidateSide& side) { return side.centroid.x() == 0; });
  b.add_node_set(20, "corner", {7, 0});
  b.add_assembly(30, "both", EntityKind::node_set, {20});
  b.add_assembly(31, "empty", EntityKind::block, {});
  return b.build();
}

/// The ids of the nodes that a fixed displacement with the set lines picks, or what is wrong with them.
std::string nodes_of(const std::string& lines) {
  const Mesh mesh = cubes_with_sets();
  ConditionDeck deck(mesh, "begin fixed displacement\n" + lines + "component = x\nend\n");
  const auto nodes =
      find_nodes(deck.region().fixed_conditions.at(0).set,
                 {"the fixed displacement", deck.region().fixed_conditions[0].name.location}, deck.scope());
  std::string text = deck.messages();
  for (const NodeIndex node : nodes) text += std::to_string(mesh.node_id(node)) + " ";
  return text;
}

}  // namespace

TEST_CASE("every kind of mesh part stands for its nodes", "[core][conditions]") {
  CHECK(nodes_of("block = block_1\n") == "1 2 3 4 5 6 7 8 ");
  CHECK(nodes_of("block = BODY\n") == "1 2 3 4 5 6 7 8 ");
  CHECK(nodes_of("include all blocks\n") == "1 2 3 4 5 6 7 8 9 10 11 12 ");
  CHECK(nodes_of("surface = left\n") == "1 3 5 7 ");
  CHECK(nodes_of("node set = corner\n") == "1 8 ");
  CHECK(nodes_of("assembly = both\n") == "1 8 ");
  CHECK(nodes_of("node = 12 3\n") == "3 12 ");
  CHECK(nodes_of("element = 2\n") == "2 4 6 8 9 10 11 12 ");
}

TEST_CASE("what is removed goes from all that is added", "[core][conditions]") {
  CHECK(nodes_of("remove surface = left\nblock = block_1\nnode set = corner\n") == "2 4 6 8 ");
  CHECK(nodes_of("include all blocks\nremove block = block_2\n") == "1 3 5 7 ");
  CHECK(nodes_of("surface = left\nremove node set = corner\n") == "3 5 7 ");
}

TEST_CASE("wrong parts of a set are errors at their place", "[core][conditions]") {
  CHECK(nodes_of("node set = corne\n") ==
        "c.i:2:12: error: the mesh has no node set 'corne'; did you mean 'corner'?\n");
  CHECK(nodes_of("remove surface = lef\nblock = corner\n") ==
        "c.i:2:18: error: the mesh has no side set 'lef'; did you mean 'left'?\n"
        "c.i:3:9: error: 'corner' is a node set of the mesh, but BLOCK takes a block\n");
  CHECK(nodes_of("node = 1 77\nelement = 3\n") ==
        "c.i:2:10: error: the mesh has no node with id 77\n"
        "c.i:3:11: error: the mesh has no element of a known type with id 3\n1 ");
  CHECK(nodes_of("assembly = empty\n") ==
        "c.i:2:12: error: assembly 'empty' holds no block, side set or node set\n");
  CHECK(nodes_of("rigid body = rb\n") ==
        "c.i:1:1: warning: the fixed displacement acts on no node [condition-empty]\n");
  CHECK(nodes_of("block = block_1\nremove block = block_1\n") ==
        "c.i:1:1: warning: the fixed displacement acts on no node [condition-empty]\n");
}

TEST_CASE("a block of an unknown type has no nodes to offer", "[core][conditions]") {
  MeshParts parts = MeshBuilder().add_hexes({.id = 1}).parts();
  parts.blocks[0].shape = Shape::unknown;
  parts.blocks[0].nodes.clear();
  const Mesh mesh(std::move(parts));
  ConditionDeck deck(mesh, "begin fixed displacement\nblock = block_1\nend\n");
  CHECK(find_nodes(deck.region().fixed_conditions.at(0).set, {"the fixed displacement", {}}, deck.scope())
            .empty());
  CHECK(deck.messages() ==
        "c.i:2:9: error: block 'block_1' holds elements of an unknown type, which the fixed displacement "
        "cannot take\n");
}
