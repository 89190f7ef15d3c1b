// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/model.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/steel_definition.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a model takes masses from volumes and densities, shared equally among nodes", "[core][model]") {
  const Mesh mesh = MeshBuilder().add_hexes({1, "", {2, 1, 1}, {0, 0, 0}, {2, 1, 1}}).build();
  Diagnostics diagnostics;
  const Model model = make_model(steel_definition("block_1"), {}, mesh, diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(model.blocks.size() == 1);
  CHECK(model.blocks[0].material == "steel (elastic)");
  CHECK(model.mass.row(0).sum() == Approx(2 * 7800.0));
  CHECK(model.mass(1, 0) == Approx(7800.0 / 8));
  CHECK(model.mass.maxCoeff() == Approx(7800.0 / 4));
}

TEST_CASE("elements on the nodes of others are warned about by block and id", "[core][model]") {
  MeshParts parts = MeshBuilder().add_hexes({.cells = {2, 1, 1}}).parts();
  parts.element_ids = {10, 20};
  std::copy_n(parts.blocks[0].nodes.begin(), 8, parts.blocks[0].nodes.begin() + 8);
  CHECK(model_errors(steel_definition("block_1"), Mesh(std::move(parts))) ==
        "1 element has the nodes of other elements, element 20 of block_1 those of element 10 of block_1\n");
}

TEST_CASE("midside nodes that one side of a face has alone are reported", "[core][model]") {
  MeshBuilder builder;
  builder.add_ten_node_tets({.id = 1, .size = {1, 1, 1}});
  SimulationDefinition definition = steel_definition("block_1");
  auto& parameters = definition.finite_element_models[0].block_parameters;
  parameters.push_back(parameters[0]);
  parameters[1].names = {deck_name("block_2")};
  SECTION("alike") {
    builder.add_ten_node_tets({.id = 2, .origin = {0, 0, 1}});
    CHECK(model_errors(definition, builder.build()).empty());
  }
  SECTION("unlike") {
    builder.add_tets({.id = 2, .origin = {0, 0, 1}}, 6);
    CHECK(model_errors(definition, builder.build()) ==
          "2 faces of six nodes lie on faces that have no or other midside nodes, the first of element 5 on "
          "element 7\n");
  }
}
