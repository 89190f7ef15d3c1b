// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "parser/command_tree.hpp"

namespace contactsim {

/// A block and the lines that may stand in it.
struct DeckSection {
  std::vector<const RowText*> around;  ///< the block last, those around it before; none: the deck's top level
  std::vector<const TreeRow*> rows;
};

/// The rows of the deck language by block, in the order of the tree; each row once.
std::vector<DeckSection> deck_sections();

}  // namespace contactsim
