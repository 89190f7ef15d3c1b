// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/text/source.hpp"

namespace contactsim {

/// One line of a deck as the language sees it: without comment, with the lines that continue it.
struct LogicalLine {
  /// A run of characters that stand side by side in the source too.
  struct Piece {
    std::size_t begin = 0;   ///< into text
    std::size_t source = 0;  ///< offset into the source's text
  };
  /// A quoted string; both ends are positions of its quote characters in text.
  struct Quote {
    std::size_t open = 0;
    std::size_t close = 0;
  };

  std::string text;
  std::vector<Piece> pieces;  ///< ascending; the first begins at 0
  std::vector<Quote> quotes;  ///< ascending, without overlap

  /// The offset into the source of the character at `position` of the text.
  std::size_t source_offset(std::size_t position) const;
};

/// Cuts a source into logical lines.
///
/// A comment runs from # or $ outside quotes to the line's end. \# and \$ continue the line: they and all
/// that follows them are dropped, and outside quotes a blank takes their place. A double quote opens a string
/// at the start of a word, or inside one if the same line closes it; it may be continued. A single quote
/// opens one at the start of a word if the same line closes it, and is an apostrophe elsewhere.
class LineReader {
 public:
  /// Both arguments must outlive the object.
  LineReader(const Source& source, Diagnostics& diagnostics);

  /// Reads the next line that holds a word into `line`, whose memory is used again; false at the end.
  bool next(LogicalLine& line);

 private:
  void read_line(LogicalLine& line);
  void read_quote(LogicalLine& line);
  bool read_continuation(LogicalLine& line, bool in_quote);
  void read_plain(LogicalLine& line);
  void copy(LogicalLine& line, std::size_t n_characters);
  void add_blank(LogicalLine& line);
  void skip_to_line_end();
  void report_control_character();
  bool opens_quote(const LogicalLine& line);
  bool is_closed_on_line(char quote);
  std::size_t line_end();

  const Source& source_;
  Diagnostics& diagnostics_;
  std::string_view text_;
  std::size_t at_ = 0;  ///< next character of text_
  // What was found last is kept, so that looking ahead from every character of a long line stays linear.
  std::size_t line_end_ = 0;
  std::size_t double_quote_ = 0;
  std::size_t single_quote_ = 0;
  std::size_t n_control_characters_ = 0;
};

}  // namespace contactsim
