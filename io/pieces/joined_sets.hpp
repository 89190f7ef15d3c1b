// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "io/pieces/divided_axis.hpp"
#include "io/pieces/open_pieces.hpp"

namespace contactsim {

/// Adds the dimensions of sets to a division that has those of nodes and elements. A set of the whole has its
/// nodes in their order and each once, its sides and elements in the order of elements and sides, unless the
/// pieces say where each entry stands (set_order_name). Throws FileError for numbers that a piece does not
/// have, and for orders and distribution factors that do not match.
void join_sets(const std::vector<OpenPiece>& pieces, Division& division);

}  // namespace contactsim
