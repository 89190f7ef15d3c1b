// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "io/pieces/divided_axis.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

/// A node of a piece that another piece has as well.
struct SharedNode {
  std::uint32_t node = 0;  ///< position in the piece
  std::uint32_t piece = 0;
};

/// A side of an element whose nodes are those of a side in another piece.
struct SharedSide {
  std::uint32_t element = 0;  ///< position in the piece
  int side = 0;               ///< from 1
  std::uint32_t piece = 0;
};

/// How a mesh is divided among pieces.
struct MeshDivision {
  Division division;                           ///< positions rise, but those of sets in their own order
  std::vector<std::vector<SharedNode>> nodes;  ///< [pieces], by node, then piece
  std::vector<std::vector<SharedSide>> sides;  ///< [pieces], by element, side, piece
  std::vector<std::string> ordered_sets;       ///< dimensions of sets that pieces must give the order of
};

/// Gives each element a piece by bisect_points at the means of their nodes.
///   n_pieces  at least 1
std::vector<std::uint32_t> bisect_elements(const Mesh& mesh, std::uint32_t n_pieces);

/// Divides whole elements; a piece has the nodes of its elements, and those of sets that it has. Nodes
/// without elements are of the first piece.
///   mesh      the mesh that is read from the file
///   piece_of  [n_elements] of the mesh, below n_pieces
///   n_pieces  at least 1
/// Throws FileError for distribution factors that match no sides. Precondition: blocks of unknown shape are
/// empty.
MeshDivision divide_mesh(const Mesh& mesh, const ExodusFile& file, std::vector<std::uint32_t> piece_of,
                         std::uint32_t n_pieces);

}  // namespace contactsim
