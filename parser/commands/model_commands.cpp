// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/model_commands.hpp"

namespace contactsim {

namespace {

constexpr const char* block_phrase = "parameters for block";

const Table<BlockParameters>& block_parameters_table() {
  static const Table<BlockParameters> table({
      flag("include all blocks", &BlockParameters::includes_all_blocks,
           "For every block that no other such block names"),
      row("remove block", read::names_of(NameKind::block), &BlockParameters::removed_blocks,
          "Blocks that these parameters are not for"),
      row("material", read::name_of(NameKind::material), &BlockParameters::material,
          "Material of the blocks"),
      row("model", read::name_of(NameKind::model), &BlockParameters::model,
          "Which model of the material the blocks take")
          .or_spelled("solid mechanics use model"),
      row("section", read::name_of(NameKind::section), &BlockParameters::section, "Section of the blocks",
          "a solid section"),
      row("linear bulk viscosity", read::non_negative, &BlockParameters::linear_bulk_viscosity,
          "Bulk viscosity linear in the strain rate [1]"),
      row("quadratic bulk viscosity", read::non_negative, &BlockParameters::quadratic_bulk_viscosity,
          "Bulk viscosity quadratic in the strain rate [1]"),
      row("hourglass stiffness", read::non_negative, &BlockParameters::hourglass_stiffness,
          "Stiffness against hourglass modes, as a share of the element's [1]")
          .or_spelled("hex hourglass stiffness"),
      row("hourglass viscosity", read::non_negative, &BlockParameters::hourglass_viscosity,
          "Viscosity against hourglass modes [1]")
          .or_spelled("hex hourglass viscosity"),
      row("effective moduli model",
          choice_of<EffectiveModuliModel>({"elastic", "pronto", "presto", "current"}),
          &BlockParameters::effective_moduli_model,
          "Moduli by which viscosity and hourglass stiffness are scaled"),
      refused<BlockParameters>("element numerical formulation", "= <words>",
                               "choose the formulation in a section"),
      refused<BlockParameters>("active periods", "= <period> ...", "blocks are active all the time"),
      refused<BlockParameters>("inactive periods", "= <period> ...", "blocks are active all the time"),
      ignored<BlockParameters>("phase", "<words>", "phases belong to coupled runs"),
  });
  return table;
}

void read_block_parameters(const Block& found, FiniteElementModel& model, Binding& binding) {
  BlockParameters parameters;
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

Row<FiniteElementModel> block_parameters_row() {
  Row<FiniteElementModel> made{{block_phrase, "<block> ...", "Material, model and section of blocks", "none",
                                Support::supported, RowText::Matches::phrase, true,
                                []() -> const TableText& { return block_parameters_table().text(); }}};
  made.read_block = [](const Block& found, const DeckName&, FiniteElementModel& model, Binding& binding) {
    read_block_parameters(found, model, binding);
  };
  return made;
}

void read_variable_alias(Arguments& arguments, FiniteElementModel& model) {
  MeshAlias alias{arguments.name(), {}};
  arguments.expect("as");
  alias.alias = arguments.name();
  model.aliases.push_back(std::move(alias));
}

void read_mesh_type(Arguments& arguments, FiniteElementModel&) {
  static const Choices types({"exodusii", "exodus", "genesis"});
  arguments.choice(types);
}

}  // namespace

const Table<FiniteElementModel>& finite_element_model_table() {
  static const Table<FiniteElementModel> table({
      row("database name", read::name, &FiniteElementModel::database,
          "Mesh file; %B stands for the deck's base name", "%B.g"),
      row<FiniteElementModel>("database type", "= {exodusII|exodus|genesis}", read_mesh_type,
                              "Format of the mesh file", "exodusII"),
      row<FiniteElementModel>("alias", "<name on the file> AS <name>", read_variable_alias,
                              "A second name for a block, side set or node set", "none"),
      block_parameters_row(),
      row("omit block", read::names_of(NameKind::block), &FiniteElementModel::omitted,
          "Blocks of the mesh file that are left out, with the nodes that they alone have"),
      row("omit assembly", read::names_of(NameKind::assembly), &FiniteElementModel::omitted,
          "Assemblies whose blocks are left out"),
      refused<FiniteElementModel>("create", "<words>", "make the set in the mesh"),
      ignored<FiniteElementModel>("decomposition method", "= <method>",
                                  "there is one process, nothing to distribute"),
      ignored<FiniteElementModel>("component separator character", "= <character>|NONE",
                                  "no variables are read by component"),
      ignored<FiniteElementModel>("global id mapping backward compatibility", "= {ON|OFF}",
                                  "ids are those of the mesh"),
      ignored<FiniteElementModel>("enable large ids", "", "ids of any size are read"),
      ignored<FiniteElementModel>("time scale factor", "= <real>", "times of the mesh file are not used"),
  });
  return table;
}

}  // namespace contactsim
