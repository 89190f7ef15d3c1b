// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_elements.hpp"

#include "core/definition/region.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The ids of the elements that an element death with the set lines takes, or what is wrong with them.
std::string elements_of(const std::string& lines) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}});
  b.add_hexes({.id = 2, .cells = {2, 1, 1}, .origin = {0, 0, 1}});
  b.add_side_set(1, "left", [](const CandidateSide& side) { return side.centroid.x() == 0; });
  b.add_node_set(1, "corner", std::vector<std::uint32_t>{0});
  b.add_assembly(1, "both", EntityKind::block, {2, 1});
  b.add_assembly(2, "sides", EntityKind::side_set, {1});
  b.set_element_ids({14, 13, 12, 11});
  const Mesh mesh = b.build();
  ConditionDeck deck(mesh, "begin element death d\n" + lines + "end\n");
  const ElementDeath& death = deck.region().element_deaths.at(0);
  const auto elements = find_elements(death.set, {"the element death", death.name.location}, deck.scope());
  std::string text = deck.messages();
  for (const ElementIndex element : elements) text += std::to_string(mesh.element_id(element)) + " ";
  return text;
}

}  // namespace

TEST_CASE("an entity set is its elements in the order of the mesh, each once", "[core][conditions]") {
  CHECK(elements_of("block = block_2 block_1\n") == "14 13 12 11 ");
  CHECK(elements_of("assembly = both\nelement = 12\n") == "14 13 12 11 ");
  CHECK(elements_of("element = 11 14\n") == "14 11 ");
  CHECK(elements_of("include all blocks\nremove block = block_1\n") == "12 11 ");
  // What is removed goes from ELEMENT lines, too.
  CHECK(elements_of("remove block = block_1\nelement = 13 12\n") == "12 ");
}

TEST_CASE("a set without elements is warned of, unless something else is wrong", "[core][conditions]") {
  CHECK(elements_of("block = block_1\nremove block = block_1\n") ==
        "c.i:1:21: warning: the element death acts on no element [condition-empty]\n");
  CHECK(elements_of("") == "c.i:1:21: warning: the element death acts on no element [condition-empty]\n");
  CHECK(elements_of("element = 99\n") ==
        "c.i:2:11: error: the mesh has no element of a known type with id 99\n");
}

TEST_CASE("what is made of nodes or sides has no elements", "[core][conditions]") {
  CHECK(elements_of("assembly = sides\nblock = block_1\n") ==
        "c.i:2:12: error: the element death acts on elements, but 'left' is a side set; use BLOCK\n14 13 ");
}
