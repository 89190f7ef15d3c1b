// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "parser/text/syntax.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"

namespace contactsim {

/// A deck text without mistakes as a tree of blocks; its file is "a.i".
inline Block block_of(const std::string& text) {
  Diagnostics diagnostics;
  Block block = parse_syntax(make_source("a.i", text), diagnostics, read_no_file);
  REQUIRE(messages(diagnostics) == "");
  return block;
}

/// One line of a deck.
inline Command command_of(const std::string& line) {
  return std::get<Command>(block_of(line + "\n").items.at(0).value);
}

}  // namespace contactsim
