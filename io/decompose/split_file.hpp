// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/pieces/piece_files.hpp"

namespace contactsim {

/// One piece that was written.
struct WrittenPiece {
  std::string path;
  std::size_t n_nodes = 0, n_elements = 0;
};

/// Divides an Exodus file, mesh or results, into pieces <base>.P.r beside it, whole elements by recursive
/// bisection. join_file makes the same variables of them again. The same file gives the same bytes.
///   path      of a file, or of pieces, which are divided anew
///   n_pieces  1 to as many as there are elements
/// All pieces appear when all are written. Throws FileError when one is there already, or when the file
/// cannot be read, divided or written.
std::vector<WrittenPiece> split_file(const std::string& path, std::size_t n_pieces);

/// The same with a piece for each element, in the order of the file. Pieces may be without any, and replace
/// files of their names.
///   piece_of  [n_elements]; elements beyond are of the first piece
void split_file(const std::string& path, const PieceFiles& files, std::span<const std::uint32_t> piece_of);

}  // namespace contactsim
