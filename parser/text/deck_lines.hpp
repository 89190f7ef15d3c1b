// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/text/ast.hpp"
#include "parser/text/line_grammar.hpp"
#include "parser/text/source.hpp"
#include "parser/text/text_file.hpp"

namespace contactsim {

/// One line of a deck, with words that know where they were written.
struct DeckLine {
  ParsedLine::Kind kind = ParsedLine::Kind::command;
  DeckLocation location;  ///< of BEGIN, END or the first word
  Command command;        ///< its words are those after BEGIN or END, if the line has one
};

/// All lines of a deck, with the lines of the files that INCLUDEFILE names in its place. Files that cannot be
/// read, include one another in a ring, are nested over 32 deep, or are too many become errors at their line.
std::vector<DeckLine> read_deck_lines(const Source& source, Diagnostics& diagnostics,
                                      const FileReader& read_file);

}  // namespace contactsim
