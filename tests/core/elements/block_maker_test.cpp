// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/block_maker.hpp"

#include <fmt/format.h>

#include "core/elements/element_table.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/steel_definition.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("blocks that cannot move are errors", "[core][model]") {
  const Mesh hexes = MeshBuilder().add_hexes({}).build();
  CHECK(model_errors(steel_definition("block_7"), hexes) == "block_1 has no PARAMETERS FOR BLOCK in 'fem'\n");
  const Mesh shells = MeshBuilder().add_shells({}).build();
  CHECK(model_errors(steel_definition("block_1"), shells) ==
        "block_1 has no thickness: neither a section nor an attribute on the mesh\n");
  SimulationDefinition strange = steel_definition("block_1");
  strange.finite_element_models[0].block_parameters[0].model = deck_name("strange");
  CHECK_THAT(model_errors(strange, hexes), Catch::Contains("model 'strange': the model is not supported"));
  SimulationDefinition section = steel_definition("block_1");
  SolidSection solid;
  solid.formulation = deck_name("q1p0");
  section.sections.push_back({deck_name("s"), {}, solid});
  section.finite_element_models[0].block_parameters[0].section = deck_name("s");
  CHECK(model_errors(section, hexes) == "block_1: there is no HEX8 with the formulation q1p0\n");
}

TEST_CASE("a section's deviatoric parameter reaches its elements, and counts 1 by default", "[core][model]") {
  const Mesh mesh = MeshBuilder().add_hexes({}).build();
  SimulationDefinition definition = steel_definition("block_1");
  SolidSection solid;
  solid.formulation = deck_name("Selective_Deviatoric");
  const auto made = [&] {
    definition.sections = {{deck_name("s"), {}, solid}};
    definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
    Diagnostics diagnostics;
    const Model model = make_model(definition, {}, mesh, diagnostics);
    CHECK(diagnostics.empty());
    REQUIRE(model.blocks.size() == 1);
    CHECK(model.blocks[0].element->n_points == 8);
    return model.blocks[0].properties.deviatoric_parameter;
  };
  CHECK(made() == 1.0);
  solid.deviatoric_parameter = 0.25;
  CHECK(made() == 0.25);
}

TEST_CASE("elements of second order are refused by name, ten-node tetrahedra apart", "[core][model]") {
  for (const Shape shape : {Shape::hex20, Shape::hex27, Shape::wedge15, Shape::pyramid13}) {
    MeshParts parts = MeshBuilder().add_hexes({}).parts();
    parts.blocks[0].id = 7;
    parts.blocks[0].name = "hull";
    parts.blocks[0].shape = shape;
    parts.blocks[0].nodes_per_element = topology(shape).n_nodes;
    parts.blocks[0].nodes.resize(topology(shape).n_nodes, NodeIndex{0});
    CHECK(model_errors(steel_definition("hull"), Mesh(std::move(parts))) ==
          fmt::format("hull (block 7) has elements of type {}, which are not supported\n",
                      topology(shape).name));
  }
}

TEST_CASE("ten-node tetrahedra are composite, by default, by a solid and by a total Lagrange section",
          "[core][model]") {
  const Mesh mesh = MeshBuilder().add_ten_node_tets({}).build();
  SimulationDefinition definition = steel_definition("block_1");
  CHECK(model_errors(definition, mesh).empty());
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  definition.sections = {{deck_name("s"), {}, SolidSection{}}};
  CHECK(model_errors(definition, mesh).empty());
  definition.sections = {{deck_name("s"), {}, TotalLagrangeSection{}}};
  CHECK(model_errors(definition, mesh) ==
        "block_1: strain is taken step by step, not from the undeformed element\n");
  SolidSection given;
  given.formulation = deck_name("selective_deviatoric");
  definition.sections = {{deck_name("s"), {}, given}};
  CHECK(model_errors(definition, mesh) ==
        "block_1: there is no TETRA10 with the formulation selective_deviatoric\n");
}

TEST_CASE("options of a solid section that are not supported are reported", "[core][model]") {
  const Mesh hexes = MeshBuilder().add_hexes({}).build();
  SimulationDefinition definition = steel_definition("block_1");
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  SolidSection solid;
  solid.strain_incrementation = deck_name("node_based");
  solid.is_hourglass_total = true;
  definition.sections.push_back({deck_name("s"), {}, solid});
  CHECK(model_errors(definition, hexes) ==
        "there is no strain incrementation 'node_based'\n"
        "block_1: hourglass forces are incremental and turn with the material\n");
  definition.sections[0].properties = ShellSection{};
  CHECK(model_errors(definition, hexes) ==
        "block_1 has elements of type HEX8, but its section 's' is not a SOLID SECTION\n");
}

TEST_CASE("sections that are not for a shape, and effects that do not exist, are reported", "[core][model]") {
  SimulationDefinition definition = steel_definition("block_1");
  BlockParameters& parameters = definition.finite_element_models[0].block_parameters[0];
  parameters.section = deck_name("s");
  definition.sections = {{deck_name("s"), {}, CohesiveSection{}}};
  const Mesh hexes = MeshBuilder().add_hexes({}).build(), tets = MeshBuilder().add_tets({}).build();
  CHECK(model_errors(definition, tets) == "block_1 has elements of type TETRA4, which cannot be cohesive\n");
  definition.sections = {{deck_name("s"), {}, TotalLagrangeSection{}}};
  CHECK(model_errors(definition, hexes) ==
        "block_1 has elements of type HEX8, but its section 's' is not a SOLID SECTION\n");
  definition.sections = {{deck_name("s"), {}, SolidSection{}}};
  parameters.effective_moduli_model = EffectiveModuliModel::presto;
  CHECK(model_errors(definition, hexes) == "block_1: EFFECTIVE MODULI MODEL has no effect\n");
  parameters.effective_moduli_model = EffectiveModuliModel::elastic;
  parameters.hourglass_viscosity = 0.1;
  CHECK(model_errors(definition, hexes) == "");
  CHECK(model_errors(definition, MeshBuilder().add_ten_node_tets({}).build()) ==
        "block_1: ten-node tetrahedra have no hourglass viscosity\n");
  parameters.model.reset();
  CHECK(model_errors(definition, hexes) == "block_1 has no MODEL\n");
  parameters.material.reset();
  CHECK(model_errors(definition, hexes) == "block_1 has no MATERIAL\n");
}

TEST_CASE("blocks get their parts of the deck's parameters, and rigid ones know it", "[core][model]") {
  SimulationDefinition definition = steel_definition("block_1");
  BlockParameters& parameters = definition.finite_element_models[0].block_parameters[0];
  parameters.hourglass_stiffness = 0.11;
  parameters.hourglass_viscosity = 0.22;
  parameters.linear_bulk_viscosity = 0.33;
  parameters.quadratic_bulk_viscosity = 0.44;
  parameters.section = deck_name("s");
  definition.sections = {{deck_name("s"), {}, SolidSection{}}};
  definition.sections[0].rigid_body = deck_name("b");
  const Mesh mesh = MeshBuilder().add_hexes({}).build();
  Diagnostics diagnostics;
  std::vector<ModelBlock> blocks;
  BlockMaker maker(definition, definition.finite_element_models[0], mesh, diagnostics);
  const std::string name = "block_1", other = "block_2";
  maker.add(0, {&other, 1}, blocks);
  CHECK(blocks.empty());
  CHECK(diagnostics.error_count() == 1);
  maker.add(0, {&name, 1}, blocks);
  REQUIRE(blocks.size() == 1);
  CHECK(diagnostics.error_count() == 1);
  const ElementProperties& made = blocks[0].properties;
  CHECK(made.density == 7800.0);
  CHECK(made.hourglass_stiffness == 0.11);
  CHECK(made.hourglass_viscosity == 0.22);
  CHECK(made.linear_bulk_viscosity == 0.33);
  CHECK(made.quadratic_bulk_viscosity == 0.44);
  CHECK(made.law.moduli().youngs() == Approx(200e9));
  CHECK(blocks[0].is_rigid);
  CHECK(blocks[0].material == "steel (elastic)");
}
