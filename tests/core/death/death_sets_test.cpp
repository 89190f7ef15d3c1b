// SPDX-License-Identifier: BSD-3-Clause
#include "core/death/death_sets.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/sample_run.hpp"

// "soft", elements 101 to 109, and "hard", 110 and 111.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The elements of the first ELEMENT DEATH block of some lines, or what is wrong with them. The blocks have
/// the materials "rubber" and "steel" by a finite element model of these parameters.
struct DeathSets {
  explicit DeathSets(const std::string& lines)
      : deck(run.mesh, "begin element death d\n" + lines + "end\n") {}

  std::string find(const std::vector<BlockParameters>& parameters = {}) {
    SimulationDefinition definition = deck.scope().definition;
    definition.finite_element_models.front().block_parameters = parameters;
    const ConditionScope of_deck = deck.scope();
    const ConditionScope scope{definition, of_deck.region, {}, run.mesh, of_deck.diagnostics};
    const auto sets = find_death_sets(scope, run.model);
    std::string text = deck.messages();
    for (const ElementIndex element : sets.at(0)) text += std::to_string(run.mesh.element_id(element)) + " ";
    return text;
  }

  SampleRun run;
  ConditionDeck deck;
};

BlockParameters parameters_of(const std::string& block, const std::string& material) {
  BlockParameters parameters;
  parameters.includes_all_blocks = block.empty();
  if (!block.empty()) parameters.names.push_back({block, {}});
  if (!material.empty()) parameters.material = DeckName{material, {}};
  return parameters;
}

const std::string always = "criterion is always true\n";

}  // namespace

TEST_CASE("INCLUDE BLOCKS WITH MATERIAL adds the blocks that are made of it", "[core][death]") {
  const std::string lines = "include blocks with material = Steel\n" + always;
  CHECK(DeathSets(lines).find({parameters_of("soft", "rubber"), parameters_of("block_20", "steel")}) ==
        "110 111 ");
  CHECK(DeathSets(lines + "element = 103\n")
            .find({parameters_of("", "rubber"), parameters_of("hard", "steel")}) == "103 110 111 ");
  // As the model is made: parameters that name a block go before those of all blocks, the first of a kind
  // counts.
  const std::string not_used = "c.i:2:32: error: no block has the material 'Steel'\n";
  CHECK(DeathSets(lines).find({parameters_of("hard", "steel"), parameters_of("", "rubber")}) == "110 111 ");
  CHECK(DeathSets(lines).find({parameters_of("hard", "rubber"), parameters_of("hard", "steel")}) == not_used);
  BlockParameters all_but_soft = parameters_of("", "steel");
  all_but_soft.removed_blocks.push_back({"SOFT", {}});
  CHECK(DeathSets(lines).find({all_but_soft}) == "110 111 ");
  CHECK(DeathSets(lines).find() == not_used);
  CHECK(DeathSets(lines).find({parameters_of("", "")}) == not_used);
}

TEST_CASE("an element death without criterion is an error", "[core][death]") {
  CHECK(
      DeathSets("block = hard\n").find() ==
      "c.i:1:21: error: the element death has no criterion: nothing would die; CRITERION IS ..., or DEATH ON "
      "INVERSION = ON\n110 111 ");
  CHECK(DeathSets("block = hard\ndeath on inversion = on\n").find() == "110 111 ");
  CHECK(DeathSets("block = hard\ndeath on ill defined contact = on\n").find() == "110 111 ");
}

TEST_CASE("elements of rigid bodies cannot die, those of blocks that were not made are passed over",
          "[core][death]") {
  DeathSets rigid("include all blocks\n" + always);
  rigid.run.model.blocks[1].is_rigid = true;
  CHECK(rigid.find() ==
        "c.i:1:21: warning: 2 elements of rigid bodies are left out: they cannot die [death-of-rigid]\n"
        "101 102 103 104 105 106 107 108 109 ");
  DeathSets unmade("include all blocks\n" + always);
  unmade.run.model.blocks.erase(unmade.run.model.blocks.begin());
  CHECK(unmade.find() == "110 111 ");
}

TEST_CASE("blocks learn which of their elements die when they turn inside out", "[core][death]") {
  DeathSets some("element = 101 109 111\ndeath on inversion = on\n");
  CHECK(some.find() == "101 109 111 ");
  const auto of_soft = some.run.model.blocks[0].dies_inverted,
             of_hard = some.run.model.blocks[1].dies_inverted;
  REQUIRE(of_soft.size() == 2);
  CHECK(of_soft[0] == 1);
  CHECK(of_soft[1] == 1);
  REQUIRE(of_hard.size() == 1);
  CHECK((of_hard[0] & 3) == 2);
  DeathSets none("block = hard\n" + always);
  none.find();
  CHECK(none.run.model.blocks[1].dies_inverted.empty());
}

TEST_CASE("an element belongs to the block that it lies in", "[core][death]") {
  const SampleRun run;
  CHECK(find_model_block(run.model, {0}) == 0);
  CHECK(find_model_block(run.model, {8}) == 0);
  CHECK(find_model_block(run.model, {9}) == 1);
  CHECK(find_model_block(run.model, {10}) == 1);
}
