// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/item_checks.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// In "contact surface s contains x" x stands in column 28.

using namespace contactsim;
using namespace contactsim::test;

namespace {

Mesh named_mesh() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "Left Plate"});
  b.add_hexes({.id = 2, .origin = {5, 0, 0}});
  b.add_side_set(10, "top", {{{0}, 6}});
  b.add_node_set(20, "corners", {0, 1});
  b.add_assembly(30, "pair", EntityKind::block, {1, 2});
  b.add_node_set(21, "pairs", {0, 1});
  return b.build();
}

/// The error at an item of CONTACT SURFACE, without its place.
std::string error_of(const std::string& item) {
  const std::string message = resolve(named_mesh(), "contact surface s contains " + item + "\n").messages;
  const std::string entity = "c.i:1:28: error: ";
  return message.rfind(entity, 0) == 0 ? message.substr(entity.size()) : message;
}

/// The errors of one line of a block form that also names block_2.
std::string error_in_block(const std::string& line) {
  return resolve(named_mesh(), "begin contact surface s\n block = block_2\n" + line + "\nend\n").messages;
}

}  // namespace

TEST_CASE("names are found without case, with blanks as underscores, and by id", "[contact][names]") {
  const std::string name =
      GENERATE(as<std::string>{}, "left_plate", "LEFT_PLATE", "'left plate'", "Block_1", "BLOCK_1");
  const Mesh mesh = named_mesh();
  const auto result = resolve(mesh, "contact surface s contains " + name + "\n");
  CHECK(result.messages.empty());
  CHECK(list_faces(mesh, result["s"]) == "1:1 1:2 1:3 1:4 1:5 1:6");
}

TEST_CASE("an unknown name comes with the nearest one of a kind that fits", "[contact][names]") {
  CHECK(error_of("left_plat") ==
        "the mesh has no side set, block or assembly 'left_plat'; did you mean 'Left Plate'?\n");
  CHECK(error_of("pairr") == "the mesh has no side set, block or assembly 'pairr'; did you mean 'pair'?\n");
  CHECK(error_of("block_3") ==
        "the mesh has no side set, block or assembly 'block_3'; did you mean 'block_2'?\n");
  CHECK(error_of("nowhere") == "the mesh has no side set, block or assembly 'nowhere'\n");
  CHECK(error_in_block(" surface = tip") ==
        "c.i:3:12: error: the mesh has no side set 'tip'; did you mean 'top'?\n");
  CHECK(error_in_block(" remove block = blocks_2") ==
        "c.i:3:17: error: the mesh has no block 'blocks_2'; did you mean 'block_2'?\n");
  CHECK(error_in_block(" remove surface = topp") ==
        "c.i:3:19: error: the mesh has no side set 'topp'; did you mean 'top'?\n");
  CHECK(error_in_block(" assembly = pai") ==
        "c.i:3:13: error: the mesh has no assembly 'pai'; did you mean 'pair'?\n");
  CHECK(resolve(named_mesh(), "skin all blocks = on exclude left_plat\n").messages ==
        "c.i:1:30: error: the mesh has no block or assembly 'left_plat'; did you mean 'Left Plate'?\n");
  CHECK(resolve(named_mesh(), "contact node set n contains cornes\n").messages ==
        "c.i:1:29: error: the mesh has no node set, side set, block or assembly 'cornes'; did you mean "
        "'corners'?\n");
}

TEST_CASE("a name of another kind comes with that kind", "[contact][names]") {
  CHECK(error_of("corners") ==
        "'corners' is a node set of the mesh, but CONTACT SURFACE takes a side set, block or assembly; nodes "
        "go "
        "into CONTACT NODE SET\n");
  CHECK(error_of("nodelist_20") ==
        "'nodelist_20' is a node set of the mesh, but CONTACT SURFACE takes a side set, block or assembly; "
        "nodes go into CONTACT NODE SET\n");
  CHECK(error_in_block(" block = pair") ==
        "c.i:3:10: error: 'pair' is an assembly of the mesh, but BEGIN CONTACT SURFACE takes a block\n");
  CHECK(error_in_block(" assembly = top") ==
        "c.i:3:13: error: 'top' is a side set of the mesh, but BEGIN CONTACT SURFACE takes an assembly\n");
  CHECK(error_in_block(" remove block = top") ==
        "c.i:3:17: error: 'top' is a side set of the mesh, but REMOVE BLOCK takes a block\n");
}

TEST_CASE("aliases are names of the mesh's parts", "[contact][names]") {
  const SimulationDefinition deck = parse_definitions(
      "begin finite element model m\n"
      "  alias block_1 as near\n"
      "  alias top as lid\n"
      "  alias block_9 as far\n"
      "  alias block_1 as block_2\n"
      "end\n");
  const auto& aliases = deck.finite_element_models.at(0).aliases;
  const auto resolve_line = [&](const std::string& item) {
    const std::string line = "contact surface s contains " + item + "\n";
    return resolve(named_mesh(), parse_region("begin contact definition\n" + line + "end\n"), aliases);
  };
  const Mesh mesh = named_mesh();
  CHECK(list_faces(mesh, resolve_line("NEAR")["s"]) == "1:1 1:2 1:3 1:4 1:5 1:6");
  CHECK(list_faces(mesh, resolve_line("lid")["s"]) == "1:6");
  CHECK(resolve_line("far").messages ==
        "c.i:2:28: error: the mesh has no 'block_9', which 'far' is an alias of; the alias stands at "
        "c.i:4:20\n");
  // A name that the mesh has is the mesh's.
  CHECK(list_faces(mesh, resolve_line("block_2")["s"]) == "2:1 2:2 2:3 2:4 2:5 2:6");
}
