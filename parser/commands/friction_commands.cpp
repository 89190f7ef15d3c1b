// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/friction_commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/interface_laws/interface_law_table.hpp"
#include "parser/commands/block_rows.hpp"
#include "parser/commands/parameter_rows.hpp"

namespace contactsim {

namespace {

/// A second model of one name that says the same as the first does no harm.
void add_model(ContactDefinition& contact, FrictionModel model, Binding& binding) {
  const auto first = std::find_if(contact.friction_models.begin(), contact.friction_models.end(),
                                  [&](const FrictionModel& other) { return other.name == model.name; });
  if (first != contact.friction_models.end() && first->law == model.law && binding.names != nullptr) {
    binding.names->drop_block();
    binding.diagnostics.add_warning(
        "deck-duplicate", model.name.location,
        fmt::format("the friction model '{}' is defined twice, with equal content", model.name.text),
        "the first stands at " + to_string(first->name.location), static_cast<int>(model.name.text.size()));
  }
  contact.friction_models.push_back(std::move(model));
}

/// A block that defines a friction model with the law of a row, whose parameters the table binds.
Row<ContactDefinition> law_row(const InterfaceLawRow& law, const Table<ParameterValues>& table) {
  Row<ContactDefinition> made{{law.name + " model", syntax_of(Naming::required), law.help, "none",
                               Support::supported, RowText::Matches::phrase, true,
                               [&table]() -> const TableText& { return table.text(); }}};
  made.read_block = [&law, &table](const Block& found, const DeckName& name, ContactDefinition& contact,
                                   Binding& binding) {
    check_name(found, name, Naming::required);
    FrictionModel model{name, make_friction_law(law.name)};
    table.bind(found, model.law.values, binding);
    add_model(contact, std::move(model), binding);
  };
  return std::move(made).defines(NameKind::friction_model);
}

}  // namespace

std::vector<Row<ContactDefinition>> friction_rows() {
  static const std::vector<Table<ParameterValues>> tables = [] {
    std::vector<Table<ParameterValues>> made;
    for (const InterfaceLawRow& law : interface_law_rows())
      made.push_back(make_parameter_table(law.parameters));
    return made;
  }();
  std::vector<Row<ContactDefinition>> rows;
  for (std::size_t i = 0; i < tables.size(); ++i) rows.push_back(law_row(interface_law_rows()[i], tables[i]));
  rows.push_back(refused_block<ContactDefinition>("user subroutine model", "User subroutines cannot be run"));
  return rows;
}

}  // namespace contactsim
