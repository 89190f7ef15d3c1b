// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/simulation.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

BlockParameters parameters_for(std::vector<std::string> names) {
  BlockParameters parameters;
  for (std::string& name : names) parameters.names.push_back({std::move(name), {}});
  return parameters;
}

}  // namespace

TEST_CASE("block parameters that name a block go before those of all blocks", "[core][definition]") {
  FiniteElementModel model;
  BlockParameters all;
  all.includes_all_blocks = true;
  all.removed_blocks = {{"block_9", {}}};
  model.block_parameters = {all, parameters_for({"Block_1", "tube"}), parameters_for({"tube"})};
  CHECK(find_block_parameters(model, "block_1") == &model.block_parameters[1]);
  CHECK(find_block_parameters(model, "TUBE") == &model.block_parameters[1]);
  CHECK(find_block_parameters(model, "block_7") == &model.block_parameters[0]);
  CHECK(find_block_parameters(model, "block_9") == nullptr);
  const std::vector<std::string> names{"block_9", "my assembly", "tube"};
  CHECK(find_block_parameters(model, names) == &model.block_parameters[1]);
}

TEST_CASE("the section of a block is found by name", "[core][definition]") {
  SimulationDefinition simulation;
  simulation.sections.push_back({{"thin", {}}, {}, ShellSection{}});
  BlockParameters parameters;
  CHECK(find_section(simulation, parameters) == nullptr);
  parameters.section = DeckName{"THIN", {}};
  CHECK(find_section(simulation, parameters) == &simulation.sections[0]);
}

TEST_CASE("the mesh file is that of the region's model", "[core][definition]") {
  SimulationDefinition simulation;
  simulation.deck_base = "drop";
  Region region;
  CHECK(mesh_path(simulation, region) == "drop.g");
  FiniteElementModel model;
  model.name.text = "m";
  model.database = DeckName{"%B_%B.exo", {}};
  simulation.finite_element_models.push_back(model);
  CHECK(mesh_path(simulation, region) == "drop_drop.exo");
  simulation.finite_element_models.emplace_back().name.text = "other";
  CHECK(find_finite_element_model(simulation, region) == nullptr);
  region.finite_element_model = DeckName{"OTHER", {}};
  CHECK(mesh_path(simulation, region) == "drop.g");
}

TEST_CASE("a deck base that holds %B is put in once", "[core][definition]") {
  SimulationDefinition simulation;
  simulation.deck_base = "%B%B";
  CHECK(expand_file_name(simulation, "a%B.e") == "a%B%B.e");
}

TEST_CASE("regions with contact are found in deck order", "[core][definition]") {
  SimulationDefinition simulation;
  simulation.procedures.resize(2);
  simulation.procedures[0].regions.resize(2);
  simulation.procedures[1].regions.resize(1);
  simulation.procedures[0].regions[1].contact.emplace();
  simulation.procedures[1].regions[0].contact.emplace();
  const std::vector<const Region*> expected{&simulation.procedures[0].regions[1],
                                            &simulation.procedures[1].regions[0]};
  CHECK(regions_with_contact(simulation) == expected);
}
