// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/model_commands.hpp"

namespace contactsim {

namespace {

using P = BlockParameters;
using F = FiniteElementModel;

constexpr const char* block_phrase = "parameters for block";

const Table<P>& block_parameters_table() {
  static const Table<P> table({
      flag("include all blocks", &P::includes_all_blocks, "For every block that no other such block names"),
      row("remove block", read::names_of(NameKind::block), &P::removed_blocks,
          "Blocks that these parameters are not for"),
      row("material", read::name_of(NameKind::material), &P::material, "Material of the blocks"),
      row("model", read::name_of(NameKind::model), &P::model, "Which model of the material the blocks take")
          .or_spelled("solid mechanics use model"),
      row("section", read::name_of(NameKind::section), &P::section, "Section of the blocks",
          "a solid section"),
      row("linear bulk viscosity", read::non_negative, &P::linear_bulk_viscosity,
          "Bulk viscosity linear in the strain rate [1]"),
      row("quadratic bulk viscosity", read::non_negative, &P::quadratic_bulk_viscosity,
          "Bulk viscosity quadratic in the strain rate [1]"),
      row("hourglass stiffness", read::non_negative, &P::hourglass_stiffness,
          "Stiffness against hourglass modes, as a share of the element's [1]")
          .or_spelled("hex hourglass stiffness"),
      row("hourglass viscosity", read::non_negative, &P::hourglass_viscosity,
          "Viscosity against hourglass modes [1]")
          .or_spelled("hex hourglass viscosity"),
      row("effective moduli model",
          choice_of<EffectiveModuliModel>({"elastic", "pronto", "presto", "current"}),
          &P::effective_moduli_model, "Moduli by which viscosity and hourglass stiffness are scaled"),
      refused<P>("element numerical formulation", "= <words>", "choose the formulation in a section"),
      refused<P>("active periods", "= <period> ...", "blocks are active all the time"),
      refused<P>("inactive periods", "= <period> ...", "blocks are active all the time"),
      ignored<P>("phase", "<words>", "phases belong to coupled runs"),
  });
  return table;
}

void read_block_parameters(const Block& found, F& model, Binding& binding) {
  P parameters;
  parameters.location = found.location;
  parameters.names = block_names(found, block_phrase);
  block_parameters_table().bind(found, parameters, binding);
  if (parameters.names.empty() && !parameters.includes_all_blocks) {
    const Word& last = found.title.back();
    throw ArgumentError{{Severity::error, "", last.location, static_cast<int>(last.text.size()),
                         "PARAMETERS FOR BLOCK needs the name of a block",
                         "name blocks on this line, or add INCLUDE ALL BLOCKS"}};
  }
  model.block_parameters.push_back(std::move(parameters));
}

Row<F> block_parameters_row() {
  Row<F> made{{block_phrase, "<block> ...", "Material, model and section of blocks", "none",
               Support::supported, RowText::Matches::phrase, true,
               []() -> const TableText& { return block_parameters_table().text(); }}};
  made.read_block = [](const Block& found, const DeckName&, F& model, Binding& binding) {
    read_block_parameters(found, model, binding);
  };
  return made;
}

void read_alias(Arguments& arguments, F& model) {
  MeshAlias alias{arguments.name(), {}};
  arguments.expect("as");
  alias.alias = arguments.name();
  model.aliases.push_back(std::move(alias));
}

void read_database_type(Arguments& arguments, F&) {
  static const std::vector<std::string> types{"exodusii", "exodus", "genesis"};
  arguments.choice(types);
}

}  // namespace

const Table<FiniteElementModel>& finite_element_model_table() {
  static const Table<F> table({
      row("database name", read::name, &F::database, "Mesh file; %B stands for the deck's base name", "%B.g"),
      row<F>("database type", "= {exodusII|exodus|genesis}", read_database_type, "Format of the mesh file",
             "exodusII"),
      row<F>("alias", "<name on the file> AS <name>", read_alias,
             "A second name for a block, side set or node set", "none"),
      block_parameters_row(),
      refused<F>("omit block", "<block> ...", "take the block out of the mesh"),
      refused<F>("omit assembly", "<assembly> ...", "take its blocks out of the mesh"),
      refused<F>("create", "<words>", "make the set in the mesh"),
      ignored<F>("decomposition method", "= <method>", "there is one process, nothing to distribute"),
      ignored<F>("component separator character", "= <character>|NONE", "no variables are read by component"),
      ignored<F>("global id mapping backward compatibility", "= {ON|OFF}", "ids are those of the mesh"),
      ignored<F>("enable large ids", "", "ids of any size are read"),
      ignored<F>("time scale factor", "= <real>", "times of the mesh file are not used"),
  });
  return table;
}

}  // namespace contactsim
