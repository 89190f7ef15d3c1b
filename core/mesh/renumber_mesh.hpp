// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// How many bits of each coordinate count along the curve.
inline constexpr int hilbert_bits = 16;

/// The place of a cell of a grid of 2^16 along each axis on Hilbert's curve through all of them, on which
/// neighbours share a side. Source: Skilling, AIP Conf. Proc. 707 (2004) 381-387.
///   cell  along x, y, z, below 2^16
std::uint64_t hilbert_place(std::array<std::uint32_t, 3> cell);

/// A mesh whose elements follow each other along Hilbert's curve, block by block, and whose nodes do as
/// elements use them, those of a block's surfaces before those inside, those of no element last: what is
/// worked on together then stands together in memory, however the file has it. Ids stay, so do blocks, sides
/// and the order of sets; node_place() and element_place() tell where the file has each. Elements whose
/// middles share a cell, and those of unknown shapes, keep their order.
Mesh renumber_mesh(Mesh mesh);

}  // namespace contactsim
