// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/deck_location.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace contactsim {

std::string to_string(const DeckLocation& location) {
  if (!location.is_known()) return "";
  return fmt::format("{}:{}:{}", location.file->name, location.line, location.column);
}

std::string line_text(const DeckLocation& location) {
  if (!location.is_known()) return "";
  const std::string& text = location.file->text;
  std::size_t begin = 0;
  for (int line = 1; line < location.line && begin < text.size(); ++line) {
    begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  }
  std::string line = text.substr(begin, text.find('\n', begin) - begin);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

}  // namespace contactsim
