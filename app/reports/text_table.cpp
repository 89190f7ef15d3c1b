// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/text_table.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "app/reports/wrap_text.hpp"

namespace contactsim {

namespace {

/// Names of up to so many columns have a field that is wide enough for them.
constexpr std::size_t longest_name = 28;

/// The line of a heading: of two, or of one that stands in the lower of two.
std::string line_of(const std::string& heading, bool is_upper) {
  const std::size_t end = heading.find('\n');
  if (end == std::string::npos) return is_upper ? "" : heading;
  return is_upper ? heading.substr(0, end) : heading.substr(end + 1);
}

}  // namespace

TextTable::TextTable(std::size_t indent, std::size_t n_keys, std::vector<Column> columns)
    : indent_(indent), n_keys_(n_keys), columns_(std::move(columns)) {
  assert(n_keys < columns_.size());
}

std::size_t TextTable::width_of(std::size_t column) const {
  const Column& of = columns_[column];
  if (of.kind == Kind::text) return of.width;
  std::size_t widest =
      std::max({of.width, n_columns(line_of(of.heading, true)), n_columns(line_of(of.heading, false))});
  for (const Cells& row : rows_) {
    const std::size_t n = n_columns(row[column]);
    if (of.kind == Kind::number || n <= longest_name) widest = std::max(widest, n);
  }
  return widest;
}

std::vector<std::vector<TextTable::Place>> TextTable::fold() const {
  std::vector<Place> keys, part;
  std::vector<std::vector<Place>> parts;
  std::size_t used = indent_, used_by_keys = indent_;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    // Behind a number, which ends where its field does, a name needs more than a blank.
    const auto gap = [&] {
      const bool is_first = used == indent_;
      return is_first ? std::size_t{0} : columns_[i].kind == Kind::number ? std::size_t{1} : std::size_t{2};
    }();
    const std::size_t width = width_of(i);
    if (i > n_keys_ && part.size() > n_keys_ && used + gap + width > line_width) {
      parts.push_back(std::exchange(part, keys));
      used = used_by_keys;
    }
    part.push_back({i, used + gap, width});
    used += gap + width;
    if (i + 1 == n_keys_) {
      keys = part;
      used_by_keys = used;
    }
  }
  parts.push_back(std::move(part));
  return parts;
}

void TextTable::append_line(const Cells& cells, const std::vector<Place>& part, std::string& text) const {
  std::string line;
  const auto end_line = [&] {
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
    line.clear();
  };
  for (const auto [column, start, width] : part) {
    const std::string& cell = cells[column];
    const bool is_number = columns_[column].kind == Kind::number;
    const std::size_t at = is_number ? start + width - n_columns(cell) : start;
    if (!line.empty() && n_columns(line) >= start && !cell.empty()) end_line();
    if (!cell.empty()) line.append(at - std::min(at, n_columns(line)), ' ').append(cell);
    if (columns_[column].kind == Kind::text) line = wrap_text(line, start);
  }
  end_line();
}

void TextTable::append_heading(const std::vector<Place>& part, std::string& text) const {
  const bool has_two_lines = std::ranges::any_of(part, [&](const Place& place) {
    return columns_[place.column].heading.find('\n') != std::string::npos;
  });
  for (const bool is_upper : {true, false}) {
    if (is_upper && !has_two_lines) continue;
    Cells cells;
    for (const Column& column : columns_) cells.push_back(line_of(column.heading, is_upper));
    append_line(cells, part, text);
  }
}

std::string TextTable::format() const {
  std::string text;
  for (const std::vector<Place>& part : fold()) {
    if (!text.empty()) text += "\n";
    append_heading(part, text);
    for (const Cells& row : rows_) append_line(row, part, text);
  }
  return text;
}

}  // namespace contactsim
