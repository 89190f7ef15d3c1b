// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/base/deck_location.hpp"

namespace contactsim {

enum class WordKind : std::uint8_t {
  bare,    ///< name, number or keyword
  quoted,  ///< text between double or single quotes, quotes taken off
  symbol   ///< one of = == < <= > >=
};

/// A word of a line. Blanks, tabs and commas separate words; symbols need none round them. A group in
/// parentheses directly behind a bare word belongs to it, blanks taken out: "stress(xx, 1)" is the word
/// "stress(xx,1)". A colon that ends a bare word is dropped: "EXPRESSION VARIABLE: v" has the words
/// EXPRESSION, VARIABLE, v.
struct Word {
  std::string text;
  WordKind kind = WordKind::bare;
  std::uint32_t begin = 0;  ///< where it starts in Command::text
  DeckLocation location;
};

/// One deck line that is neither BEGIN nor END, after comments are stripped and continuations joined. Knows
/// no command names.
struct Command {
  std::vector<Word> words;  ///< at least one; commas and blanks between words are gone
  std::string text;         ///< the joined line, for commands that take the rest of it as it is (TITLE)
};

struct Item;

/// BEGIN <title> ... END. The outermost block of a deck has no title.
struct Block {
  std::vector<Word> title;  ///< the words after BEGIN: block type, then name
  DeckLocation location;    ///< of BEGIN
  std::vector<Item> items;  ///< in deck order
  std::vector<Word> end;    ///< the words after END where they differ from the title; see check_end()
  bool is_closed = true;    ///< false when END is missing: an unknown item may belong to the block around
};

struct Item {
  std::variant<Command, Block> value;
};

}  // namespace contactsim
