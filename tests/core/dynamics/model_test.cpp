// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/model.hpp"

#include <fmt/format.h>

#include "core/definition/simulation.hpp"
#include "core/elements/element_table.hpp"
#include "core/elements/linear_advice.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/material_model.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

DeckName deck_name(const std::string& text) { return {text, {}}; }

/// One material `steel` with the models `elastic` and `strange`, given to `block`.
SimulationDefinition definition_for(const std::string& block) {
  SimulationDefinition definition;
  const MaterialModel elastic =
      test::material_model("elastic", {{"youngs modulus", 200e9}, {"poissons ratio", 0.3}});
  definition.materials.push_back({deck_name("steel"), 7800.0, {elastic, {deck_name("strange"), {}}}});
  BlockParameters parameters;
  parameters.names = {deck_name(block)};
  parameters.material = deck_name("steel");
  parameters.model = deck_name("elastic");
  definition.finite_element_models.push_back({deck_name("fem"), {}, {}, {parameters}, {}});
  return definition;
}

std::string errors_of(const SimulationDefinition& definition, const Mesh& mesh) {
  Diagnostics diagnostics;
  make_model(definition, {}, mesh, diagnostics);
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += diagnostic.text + "\n";
  return text;
}

}  // namespace

TEST_CASE("a model takes masses from volumes and densities, shared equally among nodes", "[core][model]") {
  const Mesh mesh = test::MeshBuilder().add_hexes({1, "", {2, 1, 1}, {0, 0, 0}, {2, 1, 1}}).build();
  Diagnostics diagnostics;
  const Model model = make_model(definition_for("block_1"), {}, mesh, diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(model.blocks.size() == 1);
  CHECK(model.blocks[0].material == "steel (elastic)");
  CHECK(model.mass.row(0).sum() == Approx(2 * 7800.0));
  CHECK(model.mass(1, 0) == Approx(7800.0 / 8));
  CHECK(model.mass.maxCoeff() == Approx(7800.0 / 4));
}

TEST_CASE("blocks that cannot move are errors", "[core][model]") {
  const Mesh hexes = test::MeshBuilder().add_hexes({}).build();
  CHECK(errors_of(definition_for("block_7"), hexes) == "block_1 has no PARAMETERS FOR BLOCK in 'fem'\n");
  const Mesh shells = test::MeshBuilder().add_shells({}).build();
  CHECK(errors_of(definition_for("block_1"), shells) ==
        "block_1 has no thickness: neither a section nor an attribute on the mesh\n");
  SimulationDefinition strange = definition_for("block_1");
  strange.finite_element_models[0].block_parameters[0].model = deck_name("strange");
  CHECK_THAT(errors_of(strange, hexes), Catch::Contains("model 'strange': the model is not supported"));
  SimulationDefinition section = definition_for("block_1");
  SolidSection solid;
  solid.formulation = deck_name("q1p0");
  section.sections.push_back({deck_name("s"), {}, solid});
  section.finite_element_models[0].block_parameters[0].section = deck_name("s");
  CHECK(errors_of(section, hexes) == "block_1: there is no HEX8 with the formulation q1p0\n");
}

TEST_CASE("a section's deviatoric parameter reaches its elements, and counts 1 by default", "[core][model]") {
  const Mesh mesh = test::MeshBuilder().add_hexes({}).build();
  SimulationDefinition definition = definition_for("block_1");
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

TEST_CASE("elements without volume are refused by id", "[core][model]") {
  MeshParts parts = test::MeshBuilder().add_hexes({.cells = {3, 1, 1}}).parts();
  parts.element_ids = {10, 20, 30};
  for (Eigen::Index node = 0; node < parts.coordinates.cols(); ++node) {
    if (parts.coordinates(0, node) > 0.5)
      parts.coordinates(0, node) = 1.0;  // the second cell keeps its volume
  }
  CHECK(errors_of(definition_for("block_1"), Mesh(parts)) ==
        "block_1: element 30 is without a positive volume\n");
  std::swap(parts.blocks[0].nodes[0], parts.blocks[0].nodes[4]);  // the first one is turned inside out
  std::swap(parts.blocks[0].nodes[1], parts.blocks[0].nodes[5]);
  std::swap(parts.blocks[0].nodes[2], parts.blocks[0].nodes[6]);
  std::swap(parts.blocks[0].nodes[3], parts.blocks[0].nodes[7]);
  CHECK(errors_of(definition_for("block_1"), Mesh(std::move(parts))) ==
        "block_1: element 10 and 1 more are without a positive volume\n");
}

TEST_CASE("properties and masses that nothing can be computed with are refused by block", "[core][model]") {
  const auto errors = [](double density, double modulus, double size) {
    MeshParts parts = test::MeshBuilder().add_hexes({}).parts();
    parts.coordinates *= size;
    SimulationDefinition definition = definition_for("block_1");
    definition.materials[0].density = density;
    definition.materials[0].models[0] =
        test::material_model("elastic", {{"youngs modulus", modulus}, {"poissons ratio", 0.3}});
    return errors_of(definition, Mesh(std::move(parts)));
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

TEST_CASE("elements on the nodes of others are warned about by block and id", "[core][model]") {
  MeshParts parts = test::MeshBuilder().add_hexes({.cells = {2, 1, 1}}).parts();
  parts.element_ids = {10, 20};
  std::copy_n(parts.blocks[0].nodes.begin(), 8, parts.blocks[0].nodes.begin() + 8);
  CHECK(errors_of(definition_for("block_1"), Mesh(std::move(parts))) ==
        "1 element has the nodes of other elements, element 20 of block_1 those of element 10 of block_1\n");
}

TEST_CASE("a hexahedron that turns inside out at a point is refused where points are asked for",
          "[core][model]") {
  MeshParts parts = test::MeshBuilder().add_hexes({}).parts();
  const auto corner = parts.blocks[0].nodes[6].value;
  parts.coordinates.col(corner).setConstant(0.25);  // a dent: the volume stays positive
  const Mesh mesh(std::move(parts));
  SimulationDefinition definition = definition_for("block_1");
  CHECK(errors_of(definition, mesh).empty());
  SolidSection solid;
  solid.formulation = deck_name("fully_integrated");
  definition.sections = {{deck_name("s"), {}, solid}};
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  CHECK(errors_of(definition, mesh) == "block_1: element 1 is without a positive volume\n");
}

TEST_CASE("a truss of rubber takes its initial load over a period only", "[core][model]") {
  Eigen::Matrix3Xd x(3, 2);
  x << 0, 1, 0, 0, 0, 0;
  const Mesh mesh = test::one_element_mesh(Shape::bar2, x);
  SimulationDefinition definition = definition_for("block_1");
  definition.materials[0].models[0] =
      test::material_model("neo_hookean", {{"youngs modulus", 1e6}, {"poissons ratio", 0.45}});
  definition.finite_element_models[0].block_parameters[0].model = deck_name("neo_hookean");
  const auto errors_with = [&](double load, double period) {
    definition.sections = {{deck_name("s"), {}, TrussSection{0.01, load, period}}};
    definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
    return errors_of(definition, mesh);
  };
  CHECK(errors_with(0.0, 0.0).empty());
  CHECK(errors_with(5.0, 1.0).empty());
  CHECK_THAT(errors_with(5.0, 0.0), Catch::Contains("cannot have its INITIAL LOAD from the start"));
}

TEST_CASE("elements of second order are refused by name, ten-node tetrahedra apart", "[core][model]") {
  for (const Shape shape : {Shape::hex20, Shape::hex27, Shape::wedge15, Shape::pyramid13}) {
    MeshParts parts = test::MeshBuilder().add_hexes({}).parts();
    parts.blocks[0].id = 7;
    parts.blocks[0].name = "hull";
    parts.blocks[0].shape = shape;
    parts.blocks[0].nodes_per_element = topology(shape).n_nodes;
    parts.blocks[0].nodes.resize(topology(shape).n_nodes, NodeIndex{0});
    CHECK(errors_of(definition_for("hull"), Mesh(std::move(parts))) ==
          fmt::format("hull (block 7) has elements of type {}, which are not supported\n",
                      topology(shape).name));
  }
  CHECK_THAT(linear_advice(Shape::hex20, 7),
             Catch::Contains("HEX8 or TETRA10: in Cubit BLOCK 7 ELEMENT TYPE HEX8"));
  CHECK_THAT(linear_advice(Shape::wedge15, 2), Catch::Contains("WEDGE6"));
  CHECK_THAT(linear_advice(Shape::shell6, 2), Catch::Contains("take SHELL3: in Cubit"));
  CHECK(linear_advice(Shape::hex8, 7).empty());
}

TEST_CASE("ten-node tetrahedra are composite, by default, by a solid and by a total Lagrange section",
          "[core][model]") {
  const Mesh mesh = test::MeshBuilder().add_ten_node_tets({}).build();
  SimulationDefinition definition = definition_for("block_1");
  CHECK(errors_of(definition, mesh).empty());
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  definition.sections = {{deck_name("s"), {}, SolidSection{}}};
  CHECK(errors_of(definition, mesh).empty());
  definition.sections = {{deck_name("s"), {}, TotalLagrangeSection{}}};
  CHECK(errors_of(definition, mesh) ==
        "block_1: strain is taken step by step, not from the undeformed element\n");
  SolidSection given;
  given.formulation = deck_name("selective_deviatoric");
  definition.sections = {{deck_name("s"), {}, given}};
  CHECK(errors_of(definition, mesh) ==
        "block_1: there is no TETRA10 with the formulation selective_deviatoric\n");
}

TEST_CASE("midside nodes that one side of a face has alone are told", "[core][model]") {
  test::MeshBuilder builder;
  builder.add_ten_node_tets({.id = 1, .size = {1, 1, 1}});
  SimulationDefinition definition = definition_for("block_1");
  auto& parameters = definition.finite_element_models[0].block_parameters;
  parameters.push_back(parameters[0]);
  parameters[1].names = {deck_name("block_2")};
  SECTION("alike") {
    builder.add_ten_node_tets({.id = 2, .origin = {0, 0, 1}});
    CHECK(errors_of(definition, builder.build()).empty());
  }
  SECTION("unlike") {
    builder.add_tets({.id = 2, .origin = {0, 0, 1}}, 6);
    CHECK(errors_of(definition, builder.build()) ==
          "2 faces of six nodes lie on faces that have no or other midside nodes, the first of element 5 on "
          "element 7\n");
  }
}

TEST_CASE("options of a solid section that are not supported are told", "[core][model]") {
  const Mesh hexes = test::MeshBuilder().add_hexes({}).build();
  SimulationDefinition definition = definition_for("block_1");
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  SolidSection solid;
  solid.strain_incrementation = deck_name("node_based");
  solid.is_hourglass_total = true;
  definition.sections.push_back({deck_name("s"), {}, solid});
  CHECK(errors_of(definition, hexes) ==
        "there is no strain incrementation 'node_based'\n"
        "block_1: hourglass forces are incremental and turn with the material\n");
  definition.sections[0].properties = ShellSection{};
  CHECK(errors_of(definition, hexes) ==
        "block_1 has elements of type HEX8, but its section 's' is not a SOLID SECTION\n");
}

TEST_CASE("a membrane section makes membranes of shells' blocks", "[core][model][membranes]") {
  const Mesh mesh = test::MeshBuilder().add_shells({}).build();
  SimulationDefinition definition = definition_for("block_1");
  definition.finite_element_models[0].block_parameters[0].section = deck_name("s");
  MembraneSection membrane;
  CHECK(errors_of(definition, mesh) != "");
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
  CHECK(errors_of(definition, mesh) == "block_1: MEAN_QUADRATURE stands in for selective_deviatoric\n");
  membrane.formulation = deck_name("fully_integrated");
  definition.sections[0].properties = membrane;
  CHECK(errors_of(definition, mesh) ==
        "block_1: there are no membranes with the formulation fully_integrated\n");
}

TEST_CASE("springs and point masses need no material, dampers do", "[core][model][springs]") {
  const Mesh mesh = test::MeshBuilder().add_bars({}).build();
  SimulationDefinition definition = definition_for("block_1");
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
  CHECK(model.mass(0, 1) == Approx(1.0));
  definition.sections[0].properties = DamperSection{};
  CHECK(errors_of(definition, mesh) == "block_1 has no MATERIAL\n");
}
