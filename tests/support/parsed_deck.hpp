// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "parser/deck.hpp"
#include "support/deck_dump.hpp"

namespace contactsim {

/// A deck text as the parser understands it, and what it said about it.
struct ParsedDeck {
  SimulationDefinition simulation;
  std::string messages;
};

/// Parses a text as the deck "a.i". No file is read.
inline ParsedDeck parsed(const std::string& text, const ParseOptions& options = {}) {
  Diagnostics diagnostics;
  SimulationDefinition simulation = parse_deck_text("a.i", text, options, diagnostics, read_no_file);
  return {std::move(simulation), messages(diagnostics)};
}

/// The lines inside a BEGIN SIERRA block; their first line is line 2 of the deck.
inline ParsedDeck parsed_sierra(const std::string& lines, const ParseOptions& options = {}) {
  return parsed("begin sierra\n" + lines + "end sierra\n", options);
}

}  // namespace contactsim
