// SPDX-License-Identifier: BSD-3-Clause
#include "parser/deck.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>

#include "core/base/errors.hpp"
#include "core/base/names.hpp"
#include "parser/aprepro/aprepro.hpp"
#include "parser/aprepro/deck_source.hpp"
#include "parser/commands/deck_commands.hpp"
#include "parser/commands/name_resolution.hpp"
#include "parser/text/syntax.hpp"

namespace contactsim {

namespace {

/// The overrides as Aprepro takes them, "name=value".
std::vector<std::string> assignments_of(const ParseOptions& options) {
  std::vector<std::string> assignments;
  for (const auto& [name, value] : options.overrides) assignments.push_back(name + "=" + value);
  return assignments;
}

/// The deck as a tree of blocks; nothing when its text could not be had, or holds nothing.
///   text  set to the deck after Aprepro
std::optional<Block> read_blocks(const std::string& name, const std::function<Source()>& read_source,
                                 const FileReader& read_file, std::string& text, Diagnostics& diagnostics) {
  try {
    const Source source = read_source();
    text = source.text();
    Block deck = parse_syntax(source, diagnostics, read_file);
    if (!deck.items.empty()) return deck;
    diagnostics.add_error({}, name + ": the deck is empty", "it should have a BEGIN SIERRA block");
  } catch (const DeckError&) {
    // What it carries is among the diagnostics already.
  }
  return std::nullopt;
}

/// What stands behind the SIERRA block is of it when an END too many has closed it: one error for all of
/// that.
void drop_what_follows_sierra(Block& deck, Diagnostics& diagnostics) {
  const auto is_sierra = [](const Item& item) {
    const Block* block = std::get_if<Block>(&item.value);
    return block != nullptr && !block->title.empty() && fold(block->title.front().text) == "sierra";
  };
  const auto sierra = std::find_if(deck.items.begin(), deck.items.end(), is_sierra);
  if (sierra == deck.items.end() || std::next(sierra) == deck.items.end()) return;
  const Block* next = std::get_if<Block>(&std::next(sierra)->value);
  if (next == nullptr || is_sierra(*std::next(sierra))) return;
  diagnostics.add_error(next->location, "this block stands behind the end of the SIERRA block",
                        "an END too many or a BEGIN too few is above it; nothing from here on is read");
  deck.items.erase(std::next(sierra), deck.items.end());
}

/// Whether the deck could be one of another program: not one of its lines and blocks was understood.
bool is_foreign(DeckForm form, const Block& deck, const Diagnostics& diagnostics) {
  if (form != DeckForm::contact_commands) return false;  // it has a block of ours
  const auto n_unknown = std::ranges::count(diagnostics.all(), "deck-unknown", &Diagnostic::id);
  return static_cast<std::size_t>(n_unknown) >= deck.items.size();
}

/// What a deck is read from.
struct DeckSource {
  const std::string& name;
  std::function<Source()> read;
  const FileReader& read_file;  ///< of included files
};

SimulationDefinition bind_deck(const DeckSource& source, bool is_lenient, Diagnostics& diagnostics) {
  SimulationDefinition simulation;
  const std::string& name = source.name;
  auto deck = read_blocks(name, source.read, source.read_file, simulation.text, diagnostics);
  simulation.deck_base = std::filesystem::path(name).stem().string();
  if (!deck) return simulation;
  simulation.form = find_deck_form(*deck);
  if (simulation.form == DeckForm::full) drop_what_follows_sierra(*deck, diagnostics);
  if (simulation.form != DeckForm::full) simulation.procedures.emplace_back().regions.emplace_back();
  DeckNames names;
  Binding binding{diagnostics, is_lenient, &names};
  deck_table(simulation.form).bind(*deck, simulation, binding);
  if (is_foreign(simulation.form, *deck, diagnostics)) {
    diagnostics.add_error({}, name + ": nothing in this deck is of Sierra/SM",
                          "it should have a BEGIN SIERRA block, or commands of a contact definition");
  }
  resolve_names(simulation, names, diagnostics);
  return simulation;
}

}  // namespace

SimulationDefinition parse_deck(const std::string& path, const ParseOptions& options,
                                Diagnostics& diagnostics) {
  const std::vector<std::string> overrides = assignments_of(options);
  const ApreproOptions aprepro{overrides, read_text_file, options.max_aprepro_work, options.is_lenient};
  const auto read_source = [&] { return read_deck_source(path, aprepro, diagnostics); };
  return bind_deck({path, read_source, read_text_file}, options.is_lenient, diagnostics);
}

SimulationDefinition parse_deck_text(const std::string& name, const std::string& text,
                                     const ParseOptions& options, Diagnostics& diagnostics,
                                     const FileReader& read_file) {
  const std::vector<std::string> overrides = assignments_of(options);
  const ApreproOptions aprepro{overrides, read_file, options.max_aprepro_work, options.is_lenient};
  const auto read_source = [&] { return run_aprepro(make_source(name, text), aprepro, diagnostics); };
  return bind_deck({name, read_source, read_file}, options.is_lenient, diagnostics);
}

}  // namespace contactsim
