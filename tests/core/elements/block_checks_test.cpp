// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/block_checks.hpp"

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/mesh_builder.hpp"
#include "support/steel_definition.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("elements without volume are refused by id", "[core][model]") {
  MeshParts parts = MeshBuilder().add_hexes({.cells = {3, 1, 1}}).parts();
  parts.element_ids = {10, 20, 30};
  for (Eigen::Index node = 0; node < parts.coordinates.cols(); ++node) {
    if (parts.coordinates(0, node) > 0.5)
      parts.coordinates(0, node) = 1.0;  // the second cell keeps its volume
  }
  CHECK(model_errors(steel_definition("block_1"), Mesh(parts)) ==
        "block_1: element 30 is without a positive volume\n");
  std::swap(parts.blocks[0].nodes[0], parts.blocks[0].nodes[4]);  // the first one is turned inside out
  std::swap(parts.blocks[0].nodes[1], parts.blocks[0].nodes[5]);
  std::swap(parts.blocks[0].nodes[2], parts.blocks[0].nodes[6]);
  std::swap(parts.blocks[0].nodes[3], parts.blocks[0].nodes[7]);
  CHECK(model_errors(steel_definition("block_1"), Mesh(std::move(parts))) ==
        "block_1: element 10 and 1 more are without a positive volume\n");
}

TEST_CASE("properties and masses that nothing can be computed with are refused by block", "[core][model]") {
  const auto errors = [](double density, double modulus, double size) {
    MeshParts parts = MeshBuilder().add_hexes({}).parts();
    parts.coordinates *= size;
    SimulationDefinition definition = steel_definition("block_1");
    definition.materials[0].density = density;
    definition.materials[0].models[0] =
        material_model("elastic", {{"youngs modulus", modulus}, {"poissons ratio", 0.3}});
    return model_errors(definition, Mesh(std::move(parts)));
  };
  CHECK(errors(1e50, 1e50, 1.0).empty());
  CHECK(errors(1e-50, 1e-50, 1e-20).empty());
  CHECK(errors(1e-308, 1.0, 1.0) == "block_1: a density of 1e-308 is too small to compute with\n");
  CHECK_THAT(errors(1.0, 1e308, 1.0),
             Catch::Contains("block_1: a bulk modulus of 8.33e+307 is too large") &&
                 Catch::Contains("block_1: a shear modulus of 3.85e+307 is too large"));
  CHECK(errors(1.0, 1.0, 1e-70) == "block_1: element 1 is too light to compute with: its mass is 1e-210\n");
  CHECK(errors(1.0, 1.0, 1e70) == "block_1: element 1 is too heavy to move: its mass is 1e+210\n");
}

TEST_CASE("a hexahedron that turns inside out at a point is refused where points are asked for",
          "[core][model]") {
  MeshParts parts = MeshBuilder().add_hexes({}).parts();
  const auto corner = parts.blocks[0].nodes[6].value;
  parts.coordinates.col(corner).setConstant(0.25);  // a dent: the volume stays positive
  const Mesh mesh(std::move(parts));
  SimulationDefinition definition = steel_definition("block_1");
  CHECK(model_errors(definition, mesh).empty());
  SolidSection solid;
  solid.formulation = deck_name("fully_integrated");
  definition.sections = {{deck_name("s"), {}, solid}};
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  CHECK(model_errors(definition, mesh) == "block_1: element 1 is without a positive volume\n");
}

TEST_CASE("masses and inertias that are no numbers are refused with the first element's id",
          "[core][model]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 4, .cells = {3, 1}}).set_element_ids({7, 8, 9}).build();
  const std::vector<double> thickness(3, 0.1);
  const ElementProperties properties{ElasticLaw{{3.0, 2.0}}, 5.0};
  const ModelBlock sound = make_shell_block(mesh, 0, shell4_bt_shell, properties, {}, thickness);
  const auto said = [&](const ModelBlock& block) {
    Diagnostics diagnostics;
    check_block(block, mesh, {}, diagnostics);
    return messages(diagnostics);
  };
  CHECK(said(sound) == "");
  const std::string hint = "; DENSITY, THICKNESS, AREA or the coordinates are too large\n";
  ModelBlock block = sound;
  block.inertia[0](1) = std::numeric_limits<double>::quiet_NaN();
  CHECK(said(block) ==
        "error: block_4: element 8 is too heavy to move: mass or inertia is no finite number" + hint);
  block = sound;
  block.mass[0](2) = std::numeric_limits<double>::infinity();
  block.mass[0](1) = 1e151;
  CHECK(said(block) ==
        "error: block_4: element 8 and 1 more are too heavy to move: its mass is 1e+151" + hint);
  block = sound;
  block.mass[0](0) = -1.0;
  CHECK(said(block) == "error: block_4: element 7 is without a positive volume\n");
  block.mass[0](0) = std::numeric_limits<double>::quiet_NaN();
  CHECK(said(block) ==
        "error: block_4: element 7 is too heavy to move: mass or inertia is no finite number" + hint);
  // What fills the last batch up counts nowhere; wrong properties are reported alone.
  block = sound;
  block.mass[0](3) = -1.0;
  CHECK(said(block) == "");
  block.mass[0](0) = -1.0;
  block.properties.density = std::numeric_limits<double>::quiet_NaN();
  CHECK(said(block) ==
        "error: block_4: a density of nan is too small to compute with; 1e-60 to 1e+60 is possible\n");
}
