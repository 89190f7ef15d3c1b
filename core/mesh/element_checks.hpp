// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Volume of a solid by its corners, faces taken as bilinear; negative when the element is inside out
/// [length^3].
///   nodes  [shape.n_nodes]  of one element
///   shape  of the solid family
/// Source: Davies & Salmond, AIAA Journal 23 (1985) 954-956, for the hexahedron.
double solid_volume(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes,
                    const Topology& shape);

/// Throws FileError when a block that is used cannot be: its element type is unknown or missing, or some of
/// its solids are inside out, or solids without volume or shells without area within the round-off of the
/// coordinates: these have faces without a normal, and could carry no mass; or so large that their size is no
/// number. Lists the first few of each with block, element id and size, and counts all. Volume is asked for,
/// not the Jacobian at the corners, because collapsed hexahedra are legal and have corners without one.
///   blocks  positions in mesh.blocks()
void check_elements(const Mesh& mesh, std::span<const std::uint32_t> blocks);

}  // namespace contactsim
