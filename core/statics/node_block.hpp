// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/statics/multigrid/block_matrix.hpp"
#include "core/statics/static_bodies.hpp"
#include "core/statics/static_contact.hpp"

namespace contactsim {

/// A part of the stiffness: by what the forces of one node resist the displacements of another.
struct NodeBlock {
  std::uint32_t row, column;                     ///< nodes
  Eigen::Matrix3d stiffness;                     ///< [force/length]
  bool row_turns = false, column_turns = false;  ///< moments, and rotations, in their place
};

/// The stiffness of springs by nodes.
std::vector<NodeBlock> blocks_of(const std::vector<ContactSpring>& springs);

/// The halves of blocks and of their transposes, by rows, then by columns, each once. Precondition: none is
/// of rotations.
std::vector<NodeBlock> symmetric_halves(const std::vector<NodeBlock>& blocks);

/// A matrix with blocks put in beside those that it has.
///   blocks  by rows, then by columns; none of them twice or there already
BlockMatrix<3, 3> with_blocks(const BlockMatrix<3, 3>& matrix, const std::vector<NodeBlock>& blocks);

/// A matrix without what is left of nodes that rigid bodies move.
BlockMatrix<3, 3> without_moved(const BlockMatrix<3, 3>& matrix, const StaticBodies& bodies);

}  // namespace contactsim
