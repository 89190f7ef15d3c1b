// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_parts.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes, of which another program's block stands between, by the sets and assemblies that hold them.
Mesh parted_mesh() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "left"});
  b.add_hexes({.id = 2, .name = "odd", .origin = {4, 0, 0}});
  b.add_hexes({.id = 3, .origin = {2, 0, 0}});
  b.add_side_set(5, "skin", std::vector<ElementSide>{{{0}, 1}});
  b.add_side_set(6, "odd skin", std::vector<ElementSide>{{{0}, 1}, {{1}, 1}});
  b.add_node_set(7, "ends", std::vector<std::uint32_t>{0, 1});
  b.add_assembly(8, "inner", EntityKind::block, {3});
  b.add_assembly(9, "outer", EntityKind::assembly, {8});
  MeshParts parts = b.parts();
  parts.blocks[1].shape = Shape::unknown;
  parts.blocks[1].nodes.clear();
  return Mesh(std::move(parts));
}

/// The parts of a set of a fixed displacement, "+" added and "-" removed, or what is wrong with them.
std::string parts_of(const std::string& lines) {
  const Mesh mesh = parted_mesh();
  ConditionDeck deck(mesh, "begin fixed displacement\n" + lines + "end\n");
  const FixedCondition& fixed = deck.region().fixed_conditions.at(0);
  const EntityParts parts = find_parts(fixed.set, {"the hold", fixed.name.location}, deck.scope());
  std::string text = deck.messages();
  for (const auto& [entity, name] : parts.added) text += "+" + mesh.name(entity) + "(" + name.text + ") ";
  for (const auto& [entity, name] : parts.removed) text += "-" + mesh.name(entity) + "(" + name.text + ") ";
  for (const NodeIndex node : parts.nodes) text += "n" + std::to_string(mesh.node_id(node)) + " ";
  for (const ElementIndex element : parts.elements)
    text += "e" + std::to_string(mesh.element_id(element)) + " ";
  return text;
}

}  // namespace

TEST_CASE("parts are known by the names that the deck picks them by", "[core][conditions]") {
  CHECK(parts_of("block = LEFT block_3\nsurface = surface_5\nnode set = ends\n") ==
        "+ends(ends) +skin(surface_5) +left(LEFT) +block_3(block_3) ");
  CHECK(parts_of("block = body\n") == "+left(body) ");  // by an alias
  CHECK(parts_of("assembly = outer\n") == "+block_3(outer) ");
  CHECK(parts_of("remove block = left\nremove surface = skin\nremove node set = ends\n") ==
        "-ends(ends) -skin(skin) -left(left) ");
  CHECK(parts_of("node = 9 2\nelement = 3\n") == "n9 n2 e3 ");
  CHECK(parts_of("") == "");
}

TEST_CASE("all blocks are those of known types, others are refused by name", "[core][conditions]") {
  CHECK(parts_of("include all blocks\n") == "+left(left) +block_3(block_3) ");
  CHECK(parts_of("block = odd\n") ==
        "c.i:2:9: error: block 'odd' holds elements of an unknown type, which the hold cannot take\n");
  CHECK(
      parts_of("surface = odd_skin\n") ==
      "c.i:2:11: error: side set 'odd skin' holds elements of an unknown type, which the hold cannot take\n");
  CHECK(parts_of("element = 2\n") == "c.i:2:11: error: the mesh has no element of a known type with id 2\n");
}

TEST_CASE("a rigid body stands for its blocks and node sets", "[core][conditions]") {
  const Mesh mesh = parted_mesh();
  ConditionDeck deck(mesh, "begin fixed displacement\nrigid body = RB\nend\n");
  SimulationDefinition definition = deck.scope().definition;
  RigidBodyDefinition& body = definition.rigid_bodies.emplace_back();
  body.name.text = "rb";
  body.node_sets = {{"ends", {}}, {"none", {}}};
  Diagnostics diagnostics;
  const ConditionScope scope{definition, deck.region(), {}, mesh, diagnostics};
  const EntityParts parts = find_parts(deck.region().fixed_conditions.at(0).set, {"the hold", {}}, scope);
  CHECK(diagnostics.empty());
  REQUIRE(parts.added.size() == 1);
  CHECK(parts.added[0].entity == Entity{EntityKind::node_set, 0});
  CHECK(parts.added[0].name.text == "RB");
}
