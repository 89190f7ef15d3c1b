// SPDX-License-Identifier: BSD-3-Clause
#include "parser/deck.hpp"

#include <filesystem>

#include "core/errors.hpp"
#include "parser/deck_commands.hpp"
#include "parser/name_resolution.hpp"
#include "parser/syntax.hpp"

namespace contactsim {

SimulationDefinition parse_deck(const std::string& path, const ParseOptions& options,
                                Diagnostics& diagnostics) {
  const TextFile deck = read_text_file(path);
  if (!deck.problem.empty()) throw FileError(path, deck.problem);
  return parse_deck_text(path, deck.text, options, diagnostics);
}

SimulationDefinition parse_deck_text(const std::string& name, const std::string& text,
                                     const ParseOptions& options, Diagnostics& diagnostics,
                                     const FileReader& read_file) {
  const Block deck = parse_syntax(make_source(name, text), diagnostics, read_file);
  SimulationDefinition simulation;
  simulation.deck_base = std::filesystem::path(name).stem().string();
  simulation.form = find_deck_form(deck);
  if (simulation.form != DeckForm::full) simulation.procedures.emplace_back().regions.emplace_back();
  std::vector<HeldDiagnostics> held;
  Binding binding{diagnostics, options.is_lenient, &held};
  deck_table(simulation.form).bind(deck, simulation, binding);
  if (deck.items.empty()) {
    diagnostics.add_error({}, name + ": the deck is empty", "it should have a BEGIN SIERRA block");
  }
  resolve_names(simulation, held, diagnostics);
  return simulation;
}

}  // namespace contactsim
