// SPDX-License-Identifier: BSD-3-Clause
#include "core/model.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

DeckName named(const std::string& text) { return {text, {}}; }

/// One material `steel` with the models `elastic` and `strange`, given to `block`.
SimulationDefinition definition_for(const std::string& block) {
  SimulationDefinition definition;
  ElasticModel elastic;
  elastic.elastic.youngs_modulus = 200e9;
  elastic.elastic.poissons_ratio = 0.3;
  definition.materials.push_back(
      {named("steel"), 7800.0, {{named("elastic"), elastic}, {named("strange"), {}}}});
  BlockParameters parameters;
  parameters.names = {named(block)};
  parameters.material = named("steel");
  parameters.model = named("elastic");
  definition.finite_element_models.push_back({named("fem"), {}, {}, {parameters}});
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
        "block_1 has elements of type SHELL4: only solids can move so far\n");
  SimulationDefinition strange = definition_for("block_1");
  strange.finite_element_models[0].block_parameters[0].model = named("strange");
  CHECK_THAT(errors_of(strange, hexes), Catch::Contains("model 'strange': the model is not supported"));
  SimulationDefinition section = definition_for("block_1");
  SolidSection solid;
  solid.formulation = named("q1p0");
  section.sections.push_back({named("s"), {}, solid});
  section.finite_element_models[0].block_parameters[0].section = named("s");
  CHECK(errors_of(section, hexes) == "block_1: there is no HEX8 with the formulation q1p0\n");
}
