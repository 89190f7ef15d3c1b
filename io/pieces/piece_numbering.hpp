// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "io/pieces/divided_axis.hpp"
#include "io/pieces/open_pieces.hpp"

namespace contactsim {

/// How the nodes and elements of pieces are numbered in the whole.
struct PieceNumbering {
  /// The user's ids in the order of the whole; empty when the whole has no map of them: they are 1..n.
  std::vector<std::int64_t> node_ids, element_ids;
  /// Of the maps that they are read from.
  NetcdfType node_id_type = NetcdfType::int32, element_id_type = NetcdfType::int32;
};

/// Finds the order of the whole from node_num_map and elem_num_map of all pieces: nodes as their numbers
/// rise, elements within each block likewise. Adds num_nodes, num_elem and num_el_in_blk<N> to the division.
/// Where the maps hold 1..n those are the numbers in the whole, and original_ids gives the user's ids if
/// there are others; else they are the ids themselves. Throws FileError for missing maps, numbers that no
/// piece has, and elements that two have.
PieceNumbering number_pieces(const std::vector<OpenPiece>& pieces, Division& division);

}  // namespace contactsim
