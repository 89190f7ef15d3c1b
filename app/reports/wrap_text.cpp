// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/wrap_text.hpp"

#include <algorithm>

namespace contactsim {

namespace {

bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

/// Bytes of the first characters.
std::size_t n_bytes(std::string_view text, std::size_t columns) {
  std::size_t i = 0;
  while (i < text.size() && (!begins_character(text[i]) || columns-- > 0)) ++i;
  return i;
}

/// The blank at which a line that is too long is broken: the last one that leaves more than half of the line
/// before it, or behind which stands a word that fits the next line; else the first one behind.
///   next_room  of the next line
std::size_t find_break(std::string_view line, std::size_t room, std::size_t next_room) {
  const std::size_t end = n_bytes(line, room), blank = line.rfind(' ', end);
  if (blank != std::string_view::npos && blank > line.find_first_not_of(' ')) {
    const std::string_view word = line.substr(blank + 1, line.find(' ', blank + 1) - blank - 1);
    if (blank > end / 2 || n_columns(word) <= next_room) return blank;
  }
  return line.find(' ', end);
}

void append_wrapped(std::string_view line, std::size_t indent, std::string& text) {
  std::size_t room = line_width;
  while (n_columns(line) > room) {
    const std::size_t blank = find_break(line, room, line_width - indent);
    const std::size_t next = line.find_first_not_of(' ', blank);
    if (next == std::string_view::npos) break;
    text.append(line.substr(0, line.find_last_not_of(' ', blank) + 1)).append("\n").append(indent, ' ');
    line.remove_prefix(next);
    room = line_width - indent;
  }
  text.append(line);
}

}  // namespace

std::size_t n_columns(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

std::string wrap_text(std::string_view text, std::size_t indent) {
  std::string wrapped;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    append_wrapped(text.substr(0, end), indent, wrapped);
    if (end < text.size()) wrapped += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return wrapped;
}

}  // namespace contactsim
