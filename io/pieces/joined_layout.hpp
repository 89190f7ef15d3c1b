// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/pieces/divided_axis.hpp"
#include "io/pieces/open_pieces.hpp"
#include "io/pieces/piece_numbering.hpp"

namespace contactsim {

/// What the whole file defines and the integers in it that are made anew: both id maps, the status of blocks
/// and sets, truth tables.
struct JoinedLayout {
  NetcdfLayout layout;
  std::map<std::string, std::vector<std::int64_t>, std::less<>> made;  ///< by variable
};

/// Joins the definitions of pieces: divided dimensions have the length of the whole, what is empty in all and
/// what describes the decomposition is left out. Throws FileError when pieces differ in other dimensions.
JoinedLayout join_layouts(const std::vector<OpenPiece>& pieces, const Division& division,
                          PieceNumbering numbering);

}  // namespace contactsim
