// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_commands.hpp"

#include "parser/commands/block_rows.hpp"
#include "parser/commands/condition_line_commands.hpp"
#include "parser/commands/contact_option_commands.hpp"
#include "parser/commands/contact_surface_commands.hpp"
#include "parser/commands/friction_commands.hpp"
#include "parser/commands/interaction_commands.hpp"
#include "parser/commands/smoothing_commands.hpp"

namespace contactsim {

namespace {

/// Lines and blocks that change which surfaces there are, and that contactsim does not do.
std::vector<Row<ContactDefinition>> refused_rows() {
  using C = ContactDefinition;
  const std::string planes = "Write BEGIN ANALYTIC OBJECT, TYPE = PLANE, in the region";
  return {
      refused<C>(
          "contact smooth surface", "<name> CONTAINS <item> ...",
          "Write CONTACT SURFACE, and SMOOTHING = AUTO in the interaction, or the shape in BEGIN SURFACE "
          "SMOOTHING"),
      refused_block<C>("analytic plane", planes),
      refused_block<C>("analytic cylinder", "Only planes are known: " + planes),
      refused_block<C>("analytic sphere", "Only planes are known: " + planes),
  };
}

}  // namespace

const Table<ContactDefinition>& contact_definition_table() {
  using C = ContactDefinition;
  static const Table<C> table(joined<C>({
      contact_surface_rows(),
      friction_rows(),
      interaction_rows(),
      lift_all(period_rows(), &C::periods),
      contact_option_rows(),
      smoothing_rows(),
      refused_rows(),
  }));
  return table;
}

}  // namespace contactsim
