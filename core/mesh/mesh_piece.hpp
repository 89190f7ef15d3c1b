// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/mesh/output_field.hpp"

namespace contactsim {

/// What one piece of a decomposed mesh has of it, in the order in which files have it.
struct MeshPiece {
  std::vector<std::uint32_t> nodes;                  ///< of the mesh
  std::vector<std::vector<std::uint32_t>> elements;  ///< [n_blocks] positions in the block

  /// Whose values a field of nodes, or of the elements of a block, has of it.
  std::span<const std::uint32_t> entities(const OutputField& field) const {
    return field.location == FieldLocation::node ? nodes : elements[field.block];
  }
};

/// Finds a piece: its elements and their nodes. Nodes without elements are of the first piece.
///   piece_of  [n_elements] of the mesh
MeshPiece find_piece(const Mesh& mesh, std::span<const std::uint32_t> piece_of, std::uint32_t piece);

}  // namespace contactsim
