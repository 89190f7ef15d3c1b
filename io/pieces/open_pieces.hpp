// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/netcdf/netcdf_file.hpp"
#include "io/netcdf/netcdf_layout.hpp"
#include "io/pieces/piece_files.hpp"

namespace contactsim {

/// A piece of a decomposed file, open for reading.
struct OpenPiece {
  std::unique_ptr<const NetcdfFile> file;
  NetcdfLayout layout;

  /// All values of a list of integers; empty when there is none of the name. Throws FileError when it has
  /// another length.
  std::vector<std::int64_t> integers(const std::string& variable, std::size_t length) const;
};

inline constexpr std::string_view time_dimension = "time_step";

/// Whether a file says that it is a piece.
bool is_piece(const NetcdfFile& file);

/// Opens all pieces, the first one first. Throws FileError that names the piece when one is missing, does not
/// say what the whole is, or belongs to another decomposition, another mesh or other times than the first. Of
/// times that some pieces do not have yet none has any.
std::vector<OpenPiece> open_pieces(const PieceFiles& files);

}  // namespace contactsim
