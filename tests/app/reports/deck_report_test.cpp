// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/deck_report.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a deck is counted by what it defines", "[app][report]") {
  SimulationDefinition definition;
  CHECK(format_definition(definition) ==
        "  0 materials, 0 sections, 0 functions, 0 procedures, 0 regions with contact\n");
  definition.materials.resize(1);
  definition.sections.resize(2);
  definition.functions.resize(1);
  definition.procedures.resize(2);
  definition.procedures[0].regions.resize(2);
  definition.procedures[0].regions[1].contact.emplace();
  CHECK(format_definition(definition) ==
        "  1 material, 2 sections, 1 function, 2 procedures, 1 region with contact\n");
  definition.procedures[1].regions.resize(1);
  definition.procedures[1].regions[0].contact.emplace();
  CHECK(format_definition(definition) ==
        "  1 material, 2 sections, 1 function, 2 procedures, 2 regions with contact\n");
}

TEST_CASE("a mesh is counted by what it holds, and each block has a line", "[app][report]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "low", .cells = {2, 1, 1}})
      .add_shells({.id = 2, .origin = {0, 0, 9}})
      .add_side_set(4, "top", std::vector<ElementSide>{ElementSide({0}, 6)})
      .add_node_set(5, "foot", std::vector<std::uint32_t>{0})
      .add_assembly(6, "all", EntityKind::block, {10, 2});
  CHECK(format_mesh(builder.build()) ==
        "  16 nodes, 3 elements, 2 blocks, 1 side set, 1 node set, 1 assembly\n"
        "  block low                          id       10          2 elements HEX8\n"
        "  block block_2                      id        2          1 elements SHELL4\n");
  CHECK(format_mesh(Mesh()) == "  0 nodes, 0 elements, 0 blocks, 0 side sets, 0 node sets, 0 assemblies\n");
}

TEST_CASE("a block of an unknown type has the words of its file", "[app][report]") {
  MeshParts parts = MeshBuilder().add_hexes({.id = 1, .name = "odd"}).parts();
  parts.blocks[0].shape = Shape::unknown;
  parts.blocks[0].type_name = "HEX27";
  const std::string text = format_mesh(Mesh(std::move(parts)));
  CHECK(text.ends_with(" elements 'HEX27'\n"));
}
