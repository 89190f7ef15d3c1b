// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/base/diagnostics.hpp"
#include "parser/text/ast.hpp"
#include "parser/text/source.hpp"
#include "parser/text/text_file.hpp"

namespace contactsim {

/// Builds the tree of blocks of a deck. Knows no command names but INCLUDEFILE, whose file's lines stand in
/// its place. Every BEGIN without END, END without BEGIN, unclosed quote and control character is reported;
/// after any of them the reading goes on where it does least harm.
///   read_file  how the files of INCLUDEFILE lines are read
/// The result is the deck's outermost level, a block without title.
Block parse_syntax(const Source& source, Diagnostics& diagnostics,
                   const FileReader& read_file = read_text_file);

/// Compares the words after a block's END with its title: a name that differs is a warning ("deck-end-name"),
/// a type that differs an error. A partial title is fine.
///   n_type_words  how many words of the title are the block's type, the rest being its name
void check_end(const Block& block, std::size_t n_type_words, Diagnostics& diagnostics);

}  // namespace contactsim
