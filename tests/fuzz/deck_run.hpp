// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/errors.hpp"
#include "parser/aprepro.hpp"
#include "parser/syntax.hpp"

namespace contactsim {

/// Takes a text through all stages that a deck goes through. No file is read: the name "self" in an include
/// stands for the text itself, under other names. Nothing but DeckError may be thrown, and it is caught here.
inline void run_deck(std::string_view text) {
  const FileReader read_self = [text](const std::string& path) -> TextFile {
    if (path.starts_with("self")) return {std::string(text)};
    return {"", "files are not read here", TextFile::Failure::missing};
  };
  constexpr std::size_t max_work = std::size_t{1} << 16;
  try {
    Diagnostics diagnostics;
    const Source deck = make_source("deck.i", std::string(text));
    const Source expanded = run_aprepro(deck, {{}, read_self, max_work}, diagnostics);
    const Block block = parse_syntax(expanded, diagnostics, read_no_file);
    for (const DiagnosticGroup& group : diagnostics.grouped()) format_with_caret(group, true);
  } catch (const DeckError& error) {
    for (const DiagnosticGroup& group : error.diagnostics().grouped()) format_machine(group);
  }
}

}  // namespace contactsim
