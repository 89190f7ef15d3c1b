// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/model_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// A finite element model that a region uses. Its lines begin at line 3.
ParsedDeck using_model(const std::string& lines) {
  return parsed_sierra("begin finite element model fem\n" + lines +
                       "end\n"
                       "begin presto procedure p\n"
                       "  begin presto region r\n"
                       "    use finite element model FEM\n"
                       "  end\n"
                       "end\n");
}

}  // namespace

TEST_CASE("a finite element model is bound", "[parser][model]") {
  const ParsedDeck deck = using_model(
      "  database name = ../meshes/My_Mesh.g\n"
      "  database type = exodusII\n"
      "  alias block_10 as tube\n"
      "  alias surface_3 as face\n");
  CHECK(deck.messages == "");
  const FiniteElementModel& model = deck.simulation.finite_element_models.at(0);
  CHECK(model.database->text == "../meshes/My_Mesh.g");
  REQUIRE(model.aliases.size() == 2);
  CHECK(model.aliases[1].mesh_name.text == "surface_3");
  CHECK(model.aliases[1].alias.text == "face");
}

TEST_CASE("block parameters have the defaults of the guide", "[parser][model]") {
  const ParsedDeck deck = using_model("  begin parameters for block block_1\n  end\n");
  CHECK(deck.messages == "");
  const BlockParameters& parameters = deck.simulation.finite_element_models.at(0).block_parameters.at(0);
  CHECK(parameters.linear_bulk_viscosity == 0.06);
  CHECK(parameters.quadratic_bulk_viscosity == 1.2);
  CHECK(parameters.hourglass_stiffness == 0.05);
  CHECK(parameters.hourglass_viscosity == 0.0);
  CHECK(parameters.location.line == 3);
}

TEST_CASE("block parameters are bound, in newer and older spelling", "[parser][model]") {
  const ParsedDeck deck = parsed_sierra(
      "begin finite element model fem\n"
      "  begin parameters for block block_1, block_2 tube\n"
      "    material steel\n"
      "    solid mechanics use model elastic\n"
      "    section = s\n"
      "    hex hourglass stiffness = 0.1\n"
      "    linear bulk viscosity = 0\n"
      "    effective moduli model = pronto\n"
      "  end\n"
      "  begin parameters for block\n"
      "    include all blocks\n"
      "    remove block = a b\n"
      "    material = foam\n"
      "    model = elastic\n"
      "  end\n"
      "end\n");
  CHECK(deck.messages == "");
  const auto& all = deck.simulation.finite_element_models.at(0).block_parameters;
  REQUIRE(all.size() == 2);
  CHECK(all[0].names.size() == 3);
  CHECK(all[0].names[1].location.column == 39);
  CHECK(all[0].material->text == "steel");
  CHECK(all[0].model->text == "elastic");
  CHECK(all[0].section->text == "s");
  CHECK(all[0].hourglass_stiffness == 0.1);
  CHECK(all[0].linear_bulk_viscosity == 0.0);
  CHECK(all[0].effective_moduli_model == EffectiveModuliModel::pronto);
  CHECK(all[1].includes_all_blocks);
  CHECK(all[1].removed_blocks.size() == 2);
  CHECK(all[1].model->text == "elastic");
}

TEST_CASE("both spellings of a model in one block are a repetition", "[parser][model]") {
  CHECK(
      parsed_sierra("begin finite element model f\n  begin parameters for block b\n    model = a\n    solid "
                    "mechanics use model b\n  end\nend\n")
          .messages ==
      "a.i:5:5: warning: 'model' is given twice in one block, this one counts; the other stands at a.i:4:5 "
      "[deck-repeated]\n");
}

TEST_CASE("block parameters for no block are an error", "[parser][model]") {
  CHECK(using_model("  begin parameters for block\n    model = a\n  end\n").messages ==
        "a.i:3:24: error: PARAMETERS FOR BLOCK needs the name of a block; name blocks on this line, or add "
        "INCLUDE ALL BLOCKS\n");
}

TEST_CASE("parameters that are given to one block twice are an error", "[parser][model]") {
  CHECK(using_model("  begin parameters for block a b\n  end\n  begin parameters for block B\n  end\n")
            .messages ==
        "a.i:5:30: error: the block 'B' is given parameters a second time; the first stand at a.i:3:32\n");
}

TEST_CASE("a model that is chosen without a material is an error", "[parser][model]") {
  CHECK(using_model("  begin parameters for block a\n    model = elastic\n  end\n").messages ==
        "a.i:4:13: error: the model 'elastic' is chosen without a material; add MATERIAL = <material>\n");
}

TEST_CASE("names that block parameters use must be defined", "[parser][model]") {
  CHECK(using_model("  begin parameters for block a\n    material = steel\n    section = s\n  end\n")
            .messages ==
        "a.i:4:16: error: unknown material 'steel'; the deck has no material\n"
        "a.i:5:15: error: unknown section 's'; the deck has no section\n");
}

TEST_CASE("a mesh that is not Exodus is refused by its type", "[parser][model]") {
  CHECK(
      using_model("  database type = generated\n").messages ==
      "a.i:3:19: error: expected one of exodusii, exodus, genesis for 'database type', found 'generated'\n");
}

TEST_CASE("blocks and assemblies may be omitted", "[parser][model]") {
  const ParsedDeck deck = using_model("  omit block block_3 block_4\n  omit assembly tools\n");
  CHECK(deck.messages == "");
  const auto& omitted = deck.simulation.finite_element_models.at(0).omitted;
  REQUIRE(omitted.size() == 3);
  CHECK(omitted[1].text == "block_4");
  CHECK(omitted[2].text == "tools");
}

TEST_CASE("lines that change the mesh are refused, those of parallel runs ignored", "[parser][model]") {
  CHECK(using_model("  create set\n  decomposition method = rcb\n").messages ==
        "a.i:3:3: error: 'create' is not supported and would change the answer; make the set in the mesh\n"
        "a.i:4:3: warning: 'decomposition method' has no effect here; there is one process, nothing to "
        "distribute [deck-ignored]\n");
}
