// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/diagnostics.hpp"
#include "core/definition/simulation.hpp"
#include "parser/deck.hpp"

namespace contactsim::test {

/// What the stages that a deck goes through make of it.
struct DeckRun {
  SimulationDefinition definition;
  Diagnostics diagnostics;
  std::string messages;  ///< as they are shown
};

/// Takes a text through all stages that a deck goes through. No file is read: in an include, names that begin
/// with "self" stand for the text itself. Nothing may be thrown.
inline DeckRun run_deck(std::string_view text, bool is_lenient) {
  int n_reads = 0;
  const FileReader read_self = [text, &n_reads](const std::string& path) -> TextFile {
    constexpr int max_reads = 20;
    if (path.starts_with("self") && ++n_reads <= max_reads) return {std::string(text)};
    return {"", "files are not read here", TextFile::Failure::missing};
  };
  ParseOptions options;
  options.is_lenient = is_lenient;
  options.max_aprepro_work = std::size_t{1} << 16;
  DeckRun run;
  run.definition = parse_deck_text("deck.i", std::string(text), options, run.diagnostics, read_self);
  for (const DiagnosticGroup& group : run.diagnostics.grouped())
    run.messages += format_with_caret(group, true);
  return run;
}

}  // namespace contactsim::test
