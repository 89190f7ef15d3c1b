// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/binding/deck_names.hpp"
#include "parser/binding/table_text.hpp"

namespace contactsim {

/// Which rows of a table the lines of one block give.
class GivenRows {
 public:
  /// `table` must outlive the object.
  explicit GivenRows(const TableText& table) : table_(table), latest_(table.rows.size(), nullptr) {}

  /// Notes a line, which is warned about when it replaces an earlier one.
  ///   words  of the line, or of an inner block's title; they must outlive the object
  void add(const std::vector<Word>& words, const MatchedItem& matched, Diagnostics& diagnostics);

  /// Notes in the current block of `names` which required rows and choices are not given, and of which
  /// choices several are.
  void check(DeckNames& names) const;

 private:
  void check_choice(const Choice& choice, DeckNames& names) const;

  const TableText& table_;
  std::vector<const Word*> latest_;  ///< of each row: the first word of the latest line of it
};

}  // namespace contactsim
