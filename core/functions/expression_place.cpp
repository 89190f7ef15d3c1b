// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_place.hpp"

#include <algorithm>
#include <string_view>

namespace contactsim {

namespace {

/// A character of a deck file, and the line and column that it has.
class DeckCursor {
 public:
  explicit DeckCursor(const DeckLocation& at) : place_(at), rest_(at.file->text) {
    for (int line = 1; line < at.line; ++line) skip_line();
    skip(static_cast<std::size_t>(at.column) - 1);
    place_ = at;
  }

  const DeckLocation& place() const { return place_; }
  bool is_at(std::string_view text) const { return rest_.starts_with(text); }
  bool is_at(char c) const { return rest_.starts_with(c); }

  void skip(std::size_t n_characters) {
    rest_.remove_prefix(std::min(n_characters, rest_.size()));
    place_.column += static_cast<int>(n_characters);
  }
  void skip_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++place_.line;
    place_.column = 1;
  }

 private:
  DeckLocation place_;
  std::string_view rest_;
};

}  // namespace

DeckLocation locate(const DeckExpression& expression, std::size_t offset) {
  if (!expression.location.is_known()) return expression.location;
  DeckCursor deck(expression.location);
  if (deck.is_at('"') || deck.is_at('\'')) deck.skip(1);
  for (std::size_t i = 0; i <= offset; ++i) {
    while (deck.is_at("\\#") || deck.is_at("\\$")) deck.skip_line();
    if (i == offset) return deck.place();
    if (i >= expression.text.size() || !deck.is_at(expression.text[i])) break;
    deck.skip(1);
  }
  return expression.location;
}

}  // namespace contactsim
