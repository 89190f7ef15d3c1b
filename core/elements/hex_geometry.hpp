// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/lanes.hpp"

/// Geometry of eight-node hexahedra in lanes, nodes in Exodus order.
namespace contactsim {

/// A vector at each node of eight hexahedra: [component][node].
using HexVectors = std::array<std::array<Lanes, 8>, 3>;

/// A tensor of each element, [i][j].
using TensorLanes = std::array<std::array<Lanes, 3>, 3>;

/// The derivatives of a hexahedron's volume by its nodes' coordinates, which are also its volume times the
/// mean gradients of the shape functions. Dimension [length^2]. Source: Flanagan and Belytschko, Int. J.
/// Numer. Meth. Eng. 17 (1981) 679-706, eq. 79.
HexVectors volume_gradient(const HexVectors& x);

/// Volume of the hexahedra, from their coordinates and the gradient at them [length^3].
Lanes hex_volume(const HexVectors& x, const HexVectors& gradient);

/// Sum over the nodes of a_i b_j, [i][j].
TensorLanes outer_sum(const HexVectors& a, const HexVectors& b);

/// The four hourglass patterns summed with a value at each node: eta zeta, xi zeta, xi eta, xi eta zeta.
std::array<Lanes, 4> hourglass_sums(const std::array<Lanes, 8>& values);

/// Adds to each node the patterns' signs times the amounts: the transpose of hourglass_sums.
void add_hourglass(const std::array<Lanes, 4>& amounts, std::array<Lanes, 8>& values);

}  // namespace contactsim
