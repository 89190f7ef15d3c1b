// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "io/decompose/mesh_division.hpp"
#include "io/netcdf/netcdf_layout.hpp"

namespace contactsim {

/// What one piece of a file defines and the values that the file does not have.
struct PieceLayout {
  NetcdfLayout layout;
  std::map<std::string, NetcdfValues, std::less<>> made;  ///< by variable
};

/// The whole file as pieces say it.
struct WholeFile {
  const ExodusFile& file;
  NetcdfLayout layout;  ///< as make_writable gives it
  const MeshDivision& division;
  std::uint32_t n_pieces = 1;
};

/// Defines one piece as nem_spread does: the numbers in the whole in node_num_map and elem_num_map, the
/// user's ids in further maps named original_ids, empty blocks and sets with status 0, numbers of the whole,
/// internal and border nodes and elements, and what is shared with other pieces. Where sets have another
/// order than that of their nodes or elements, variables as set_order_name tell it.
PieceLayout make_piece_layout(const WholeFile& whole, std::uint32_t piece);

/// The values of a variable of the whole, or of one record of it, that a piece has.
///   record  whether they are of one record
NetcdfValues take_part(const WholeFile& whole, const NetcdfDefinition& variable, bool record,
                       const NetcdfValues& values, std::uint32_t piece);

/// The name of a variable of the whole in pieces.
std::string name_in_piece(const NetcdfDefinition& variable);

}  // namespace contactsim
