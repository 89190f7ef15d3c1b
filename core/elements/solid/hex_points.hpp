// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/solid/hex_geometry.hpp"

/// The eight Gauss points of hexahedra, two along each natural coordinate, weights 1. Point p lies at
/// +-1/sqrt(3) with the signs of its bits: bit 0 for xi, 1 for eta, 2 for zeta. Nodes stand in Exodus order.
namespace contactsim {

inline constexpr std::size_t n_hex_points = 8;

/// Derivatives of a trilinear field by the three natural coordinates, at all points. Each does not change
/// along its own coordinate: there are four values, by the signs of the other two coordinates, the first of
/// which counts 1 and the second 2. [coordinate][signs]
using NaturalSlopes = std::array<std::array<Lanes, 4>, 3>;

/// Slopes of a field with these sums over the nodes.
NaturalSlopes natural_slopes(const HexSums& sums);

/// The transpose: adds the slopes' amounts, as amounts of the base vectors.
void add_from_slopes(const NaturalSlopes& amounts, HexSums& forces);

/// Where a point's slope along a natural coordinate stands.
constexpr std::size_t signs_at(std::size_t point, std::size_t coordinate) {
  if (coordinate == 0) return point >> 1;
  return coordinate == 1 ? (point & 1) + (point >> 2) * 2 : point & 3;
}

/// Slopes of the three components of a vector: [component].
using VectorSlopes = std::array<NaturalSlopes, 3>;

///   sums  of the components over the nodes
VectorSlopes vector_slopes(const NodeVectors<7>& sums);

/// [component][natural coordinate]
TensorLanes slopes_at(const VectorSlopes& slopes, std::size_t point);

/// The map from natural to real coordinates at one point.
struct PointMap {
  TensorLanes cofactors;  ///< of the map's gradient: cofactors / volume is its inverse, transposed [length^2]
  Lanes volume;           ///< its determinant, the volume that belongs to the point [length^3]
};

PointMap point_map(const VectorSlopes& coordinates, std::size_t point);

/// The volume of hexahedra [length^3]; where the map turns inside out at a point, the volume of that point,
/// which is not positive.
Lanes volume_of_points(const VectorSlopes& coordinates);

}  // namespace contactsim
