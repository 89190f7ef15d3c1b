// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/binding/table.hpp"

namespace contactsim {

/// One row of the deck language and the blocks around it.
struct TreeRow {
  const RowText* row = nullptr;
  std::vector<const RowText*> around;  ///< outermost first
  /// A block whose contents were listed before: the row under which they stand. Null: they follow.
  const RowText* same_as = nullptr;
};

/// Every row of a full deck's language, a block before its contents, each table's contents once.
const std::vector<TreeRow>& command_tree();

/// The text in capitals.
std::string upper(std::string_view text);

/// A row as a deck would have it, keywords in capitals: "BEGIN FUNCTION <name>", "THICKNESS = <real > 0>".
std::string deck_form_of(const RowText& row);

}  // namespace contactsim
