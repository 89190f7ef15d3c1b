// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/deck_commands.hpp"

#include <algorithm>

#include "parser/commands/contact_commands.hpp"
#include "parser/commands/region_commands.hpp"
#include "parser/commands/row_lists.hpp"
#include "parser/commands/sierra_commands.hpp"

namespace contactsim {

namespace {

bool is_block(const Item& item, std::string_view phrase) {
  const Block* block = std::get_if<Block>(&item.value);
  return block != nullptr && match_phrase(split_phrase(phrase), block->title) > 0;
}

void read_sierra(const Block& found, const DeckName& name, SimulationDefinition& simulation,
                 Binding& binding) {
  if (simulation.name.location.is_known()) {
    throw ArgumentError{{Severity::error, "", found.location, 1, "a second BEGIN SIERRA in one deck",
                         "the first stands at " + to_string(simulation.name.location)}};
  }
  simulation.name = {name.text, found.location};
  sierra_table().bind(found, simulation, binding);
}

std::vector<Row<SimulationDefinition>> sierra_row() {
  Row<SimulationDefinition> made{{"sierra", "[<title>]", "A whole run", "none", Support::supported,
                                  RowText::Matches::phrase, true,
                                  []() -> const TableText& { return sierra_table().text(); }}};
  made.read_block = read_sierra;
  return {made};
}

Region& region_of(SimulationDefinition& simulation) { return simulation.procedures.front().regions.front(); }

ContactDefinition& contact_of(SimulationDefinition& simulation) {
  auto& contact = region_of(simulation).contact;
  if (!contact) contact.emplace();
  return *contact;
}

template <class Part>
std::vector<Row<SimulationDefinition>> lift_all_by(const std::vector<Row<Part>>& rows_of_part,
                                                   Part& (*part_of)(SimulationDefinition&)) {
  std::vector<Row<SimulationDefinition>> lifted;
  lifted.reserve(rows_of_part.size());
  for (const Row<Part>& row_of_part : rows_of_part)
    lifted.push_back(lift<SimulationDefinition, Part>(row_of_part, part_of));
  return lifted;
}

}  // namespace

DeckForm find_deck_form(const Block& deck) {
  const auto has = [&](std::string_view phrase) {
    return std::any_of(deck.items.begin(), deck.items.end(),
                       [&](const Item& item) { return is_block(item, phrase); });
  };
  if (has("sierra")) return DeckForm::full;
  return has("contact definition") ? DeckForm::contact_definition : DeckForm::contact_commands;
}

const Table<SimulationDefinition>& deck_table(DeckForm form) {
  static const Table<SimulationDefinition> full(sierra_row());
  static const Table<SimulationDefinition> definition(
      joined({sierra_row(), definition_rows(), lift_all_by(region_table().rows(), region_of)}));
  static const Table<SimulationDefinition> commands(
      joined({sierra_row(), definition_rows(), lift_all_by(contact_definition_table().rows(), contact_of),
              lift_all_by(region_table().rows(), region_of)}));
  switch (form) {
    case DeckForm::full:
      return full;
    case DeckForm::contact_definition:
      return definition;
    case DeckForm::contact_commands:
      return commands;
  }
  return full;
}

}  // namespace contactsim
