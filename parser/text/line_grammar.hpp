// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "parser/text/ast.hpp"
#include "parser/text/lines.hpp"

namespace contactsim {

/// A logical line taken apart. Positions are into the line's text.
struct ParsedLine {
  enum class Kind { command, begin, end };
  struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;  ///< one past the last character; quotes are inside the span
    WordKind kind = WordKind::bare;
  };

  Kind kind = Kind::command;
  std::size_t keyword = 0;  ///< where BEGIN or END stands; unused for a command
  std::vector<Span> words;  ///< without BEGIN or END
};

/// Takes a line apart into `parsed`, whose memory is used again. Every line has a parse.
void parse_line(const LogicalLine& line, ParsedLine& parsed);

}  // namespace contactsim
