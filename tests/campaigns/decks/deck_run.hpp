// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/base/diagnostics.hpp"
#include "parser/deck.hpp"

namespace contactsim {

/// Takes a text through all stages that a deck goes through. No file is read: in an include, names that begin
/// with "self" stand for the text itself. Nothing may be thrown.
inline void run_deck(std::string_view text) {
  int n_reads = 0;
  const FileReader read_self = [text, &n_reads](const std::string& path) -> TextFile {
    constexpr int max_reads = 20;
    if (path.starts_with("self") && ++n_reads <= max_reads) return {std::string(text)};
    return {"", "files are not read here", TextFile::Failure::missing};
  };
  ParseOptions options;
  options.is_lenient = text.size() % 2 == 1;
  options.max_aprepro_work = std::size_t{1} << 16;
  Diagnostics diagnostics;
  parse_deck_text("deck.i", std::string(text), options, diagnostics, read_self);
  for (const DiagnosticGroup& group : diagnostics.grouped()) format_with_caret(group, true);
}

}  // namespace contactsim
