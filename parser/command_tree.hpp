// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

}  // namespace contactsim
