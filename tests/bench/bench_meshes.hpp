// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/mesh.hpp"

namespace contactsim::bench {

/// A cube of n x n x n unit hexahedra in cubic blocks of n / n_blocks cells along each edge.
///   shuffled  whether the elements of each block stand in a random (fixed) order
/// Precondition: n_blocks divides n.
Mesh make_hex_cube(std::uint32_t n, std::uint32_t n_blocks = 1, bool shuffled = false);

/// A cube of n x n x n unit cells of six tetrahedra each.
Mesh make_tet_cube(std::uint32_t n);

}  // namespace contactsim::bench
