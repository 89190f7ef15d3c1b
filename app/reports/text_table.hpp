// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace contactsim {

/// A table of the log. A column is as wide as it says and no wider than its longest cell asks for; columns
/// that would go beyond line_width stand in a further part below, behind the first columns again. So a table
/// depends on what it holds alone, and narrow changes of it are narrow in a diff.
class TextTable {
 public:
  enum class Kind : std::uint8_t {
    number,  ///< at the right, as wide as its longest cell
    name,    ///< at the left; what follows a cell that is too long stands on the next line
    text     ///< at the left and last, broken at blanks
  };
  struct Column {
    std::string heading;    ///< of one or two lines
    std::size_t width = 0;  ///< at least
    Kind kind = Kind::number;
  };

  /// Preconditions: n_keys < columns.size().
  ///   n_keys  columns that every part begins with
  TextTable(std::size_t indent, std::size_t n_keys, std::vector<Column> columns);

  /// Precondition: a cell for every column.
  template <class... Cells>
  void add(const Cells&... cells) {
    rows_.push_back({fmt::format("{}", cells)...});
  }
  bool empty() const { return rows_.empty(); }

  std::string format() const;

 private:
  using Cells = std::vector<std::string>;
  struct Place {
    std::size_t column, start, width;  ///< start: columns of the line before the field
  };

  std::size_t width_of(std::size_t column) const;
  std::vector<std::vector<Place>> fold() const;
  void append_line(const Cells& cells, const std::vector<Place>& part, std::string& text) const;
  void append_heading(const std::vector<Place>& part, std::string& text) const;

  std::size_t indent_, n_keys_;
  std::vector<Column> columns_;
  std::vector<Cells> rows_;
};

inline TextTable::Column name_column(std::string heading, std::size_t width) {
  return {std::move(heading), width, TextTable::Kind::name};
}

inline TextTable::Column text_column(std::string heading) {
  return {std::move(heading), 20, TextTable::Kind::text};
}

}  // namespace contactsim
