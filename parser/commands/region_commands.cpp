// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/region_commands.hpp"

#include "parser/commands/condition_commands.hpp"
#include "parser/commands/condition_initial_commands.hpp"
#include "parser/commands/condition_load_commands.hpp"
#include "parser/commands/contact_commands.hpp"
#include "parser/commands/contact_surface_commands.hpp"
#include "parser/commands/output_commands.hpp"
#include "parser/commands/output_user_commands.hpp"
#include "parser/commands/region_part_commands.hpp"
#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

void read_finite_element_model(Arguments& arguments, Region& region) {
  region.finite_element_model = arguments.reference(NameKind::finite_element_model);
  if (arguments.at_end()) return;
  const Word& word = arguments.peek();
  arguments.expect("model");
  arguments.expect("coordinates");
  arguments.refuse(word, "'MODEL COORDINATES ARE' is not supported, the mesh's own coordinates are taken");
}

/// Two definitions would each own faces of one mesh, which no rule orders, even in periods of their own.
void add_contact(Region& region, ContactDefinition contact) {
  if (!region.contact) {
    region.contact = std::move(contact);
    return;
  }
  const std::string first = to_string(region.contact->name.location);
  throw ArgumentError{
      {Severity::error, "", contact.name.location, 1,
       "a second CONTACT DEFINITION in one region is not supported",
       "the first stands at " + first +
           "; one definition names the surfaces of all periods, and ACTIVE PERIODS in its interactions, with "
           "INTERACTION BEHAVIOR = NO_INTERACTION too, says which pairs meet when"},
      true};
}

std::vector<Row<Region>> head_rows() {
  using R = Region;
  const std::string planes = "Write BEGIN ANALYTIC OBJECT, TYPE = PLANE";
  return {
      row<R>("use finite element model", "<name>", read_finite_element_model,
             "The finite element model that the region works on", "the only one, with a warning")
          .references(NameKind::finite_element_model)
          .once(),
      ignored<R>("logfile precision", "= <n>", "The log has its own precision"),
      ignored<R>("global energy reporting", "= {EXACT|APPROXIMATE|OFF}", "Energies are always exact"),
      ignored<R>("extensive global vars", "<words>", "Global variables are written when they are asked for"),
      ignored<R>("extensive rigid body vars output", "= <words>",
                 "Rigid body variables are written when they are asked for"),
      ignored<R>("level 1 predictor", "= <words>", "Of implicit runs only"),
      block<R, ContactDefinition>("contact definition", Naming::optional, contact_definition_table,
                                  add_contact, "Contact surfaces and how they meet")
          .defines(NameKind::contact_definition),
      block<R, AnalyticPlane>("analytic object", Naming::required, analytic_object_table, &R::analytic_planes,
                              "A plane that contact surfaces may contain")
          .defines(NameKind::analytic_object),
      refused_block<R>("analytic plane", planes),
      refused_block<R>("analytic cylinder", "Only planes are known: " + planes),
      refused_block<R>("analytic sphere", "Only planes are known: " + planes),
  };
}

}  // namespace

const Table<Region>& region_table() {
  static const Table<Region> table(joined<Region>({
      head_rows(),
      kinematic_condition_rows(),
      load_rows(),
      initial_condition_rows(),
      other_condition_rows(),
      region_part_rows(),
      output_rows(),
      user_output_rows(),
  }));
  return table;
}

}  // namespace contactsim
