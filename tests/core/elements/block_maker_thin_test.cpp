// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_table.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"
#include "support/steel_definition.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a truss of rubber takes its initial load over a period only", "[core][model]") {
  Eigen::Matrix3Xd x(3, 2);
  x << 0, 1, 0, 0, 0, 0;
  const Mesh mesh = one_element_mesh(Shape::bar2, x);
  SimulationDefinition definition = steel_definition("block_1");
  definition.materials[0].models[0] =
      material_model("neo_hookean", {{"youngs modulus", 1e6}, {"poissons ratio", 0.45}});
  definition.finite_element_models[0].block_parameters[0].model = deck_name("neo_hookean");
  const auto errors_with = [&](double load, double period) {
    definition.sections = {{deck_name("s"), {}, TrussSection{0.01, load, period}}};
    definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
    return model_errors(definition, mesh);
  };
  CHECK(errors_with(0.0, 0.0).empty());
  CHECK(errors_with(5.0, 1.0).empty());
  CHECK_THAT(errors_with(5.0, 0.0), Catch::Contains("cannot have its INITIAL LOAD from the start"));
}

TEST_CASE("a membrane section makes membranes of shells' blocks", "[core][model][membranes]") {
  const Mesh mesh = MeshBuilder().add_shells({}).build();
  SimulationDefinition definition = steel_definition("block_1");
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  MembraneSection membrane;
  CHECK(model_errors(definition, mesh) != "");
  membrane.thickness = 0.1;
  membrane.thickness_scale_factor = 2.0;
  definition.sections.push_back({deck_name("s"), {}, membrane});
  Diagnostics diagnostics;
  const Model model = make_model(definition, {}, mesh, diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(model.blocks.size() == 1);
  CHECK(model.blocks[0].element == find_membrane_element(mesh.blocks()[0].shape));
  CHECK(model.blocks[0].thickness[0](0) == 0.2);
  CHECK(model.blocks[0].layout.n_points == 1);
  CHECK(model.inertia.cols() == 0);
  membrane.formulation = deck_name("selective_deviatoric");
  definition.sections[0].properties = membrane;
  CHECK(model_errors(definition, mesh) == "block_1: MEAN_QUADRATURE stands in for selective_deviatoric\n");
  membrane.formulation = deck_name("fully_integrated");
  definition.sections[0].properties = membrane;
  CHECK(model_errors(definition, mesh) ==
        "block_1: there are no membranes with the formulation fully_integrated\n");
}

TEST_CASE("springs and point masses need no material, dampers do", "[core][model][springs]") {
  const Mesh mesh = MeshBuilder().add_bars({}).build();
  SimulationDefinition definition = steel_definition("block_1");
  BlockParameters& parameters = definition.finite_element_models[0].block_parameters[0];
  parameters.material.reset();
  parameters.model.reset();
  parameters.section = deck_name("s");
  definition.sections.push_back({deck_name("s"), {}, SpringSection{{}, 5.0, {}, 2.0}});
  Diagnostics diagnostics;
  const Model model = make_model(definition, {}, mesh, diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(model.blocks.size() == 1);
  CHECK(model.blocks[0].material == "none");
  CHECK(model.mass(1) == Approx(1.0));
  definition.sections[0].properties = DamperSection{};
  CHECK(model_errors(definition, mesh) == "block_1 has no MATERIAL\n");
}

TEST_CASE("formulations of shells stand in for each other or are refused with what there is",
          "[core][model]") {
  SimulationDefinition definition = steel_definition("block_1");
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  const auto with = [&](const std::string& formulation, const Mesh& mesh) {
    ShellSection shell;
    shell.formulation = deck_name(formulation);
    shell.thickness = 0.1;
    definition.sections = {{deck_name("s"), {}, shell}};
    return model_errors(definition, mesh);
  };
  const Mesh quads = MeshBuilder().add_shells({}).build(),
             triangles = MeshBuilder().add_triangles({}).build();
  CHECK(with("BT_Shell", quads) == "");
  CHECK(with("bt_shell", triangles) == "");
  CHECK(with("c0_tri_shell", triangles) == "");
  CHECK(with("KH_SHELL", quads) == "block_1: BT_SHELL stands in for KH_SHELL\n");
  CHECK(with("bl_shell", quads) == "block_1: BT_SHELL stands in for bl_shell\n");
  CHECK(with("nqueg", quads) == "block_1: there is no SHELL4 with the formulation nqueg\n");
  CHECK(with("c0_tri_shell", quads) == "block_1: there is no SHELL4 with the formulation c0_tri_shell\n");
  definition.sections = {{deck_name("s"), {}, SolidSection{}}};
  CHECK(model_errors(definition, quads) ==
        "block_1 has elements of type SHELL4, but its section 's' is not a SHELL or MEMBRANE SECTION\n");
}

TEST_CASE("materials that lines do not take are refused by their model", "[core][model]") {
  SimulationDefinition definition = steel_definition("block_1");
  definition.materials[0].models[0] =
      material_model("mooney_rivlin", {{"bulk modulus", 1e9}, {"c10", 2e6}, {"c01", 1e6}});
  definition.finite_element_models[0].block_parameters[0].model = deck_name("mooney_rivlin");
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  definition.sections = {{deck_name("s"), {}, TrussSection{0.01, 0.0, 0.0}}};
  CHECK(model_errors(definition, MeshBuilder().add_bars({}).build()) ==
        "block_1: beams and trusses of the model mooney_rivlin are not supported\n");
}
