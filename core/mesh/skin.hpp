// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The outside of a set of elements.
struct Skin {
  std::vector<ElementSide> exterior;  ///< faces of solids that no other present element shares, ascending
  /// [n_blocks] faces of a block's solids that are shared with other blocks only: exterior to the block taken
  /// alone, interior to all present elements together.
  std::vector<std::uint32_t> in_between;

  /// The exterior faces of one block, a part of `exterior`.
  std::span<const ElementSide> sides_of_block(const ElementBlock& block) const;
};

/// Finds the exterior faces of the present elements: a face of a solid is exterior unless another present
/// solid, or a present shell, has the same corner nodes. Faces are compared by their sets of corner nodes, so
/// a hexahedron that is degenerate to a wedge meets its neighbours; a face that has fewer than three
/// different nodes is none.
///   present  [n_elements] 0 or 1; lines and particles have no faces, whatever their mark
/// Time O(n), memory about 30 bytes per element above the mesh. Runs on OpenMP's threads; the result does not
/// depend on their number. Source: rules of Sierra/SM 5.22, 8.4.8; bucket sort of faces by smallest node, a
/// cache of nodes at a time.
Skin make_skin(const Mesh& mesh, std::span<const std::uint8_t> present);

}  // namespace contactsim
