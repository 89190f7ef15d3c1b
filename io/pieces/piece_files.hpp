// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace contactsim {

/// The files of a decomposed Exodus file: base.P.r, r from 0 to P - 1 padded with zeros to the width of P, as
/// in "mesh.g.16.03". Source: Sandia's IOSS library, names of a file for each processor.
struct PieceFiles {
  std::string base;
  std::size_t count = 1;  ///< P
  std::size_t width = 1;  ///< of r [characters]

  std::string path(std::size_t piece) const;
  bool operator==(const PieceFiles&) const = default;
};

/// The names that `count` pieces of a file are written under.
PieceFiles name_pieces(const std::string& base, std::size_t count);

/// The decomposition that a path names a piece of, by its name alone.
std::optional<PieceFiles> parse_piece_path(const std::string& path);

/// The decompositions of a file of which at least one piece is there, from the fewest pieces to the most.
/// Some writers pad to the width of P - 1: that differs for 10, 100, ... pieces, and is known too.
std::vector<PieceFiles> find_decompositions(const std::string& base);

/// The file to open for a path: itself where it is there, or where there are no pieces of it, else the first
/// of its pieces. Of several decompositions the one of as many pieces as ranks is taken. Throws FileError
/// when there is none such.
std::string find_exodus_path(const std::string& path, std::size_t n_ranks);

}  // namespace contactsim
