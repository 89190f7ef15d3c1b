// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim::bench {

// Elements and nodes are numbered as a run numbers them: renumber_mesh().

/// A cube of n x n x n unit hexahedra in cubic blocks of n / n_blocks cells along each edge.
///   shuffled  the elements of each block stand in a random (fixed) order instead
/// Precondition: n_blocks divides n.
Mesh make_hex_cube(std::uint32_t n, std::uint32_t n_blocks = 1, bool shuffled = false);

/// A square sheet of n x n unit shells of four nodes, slightly warped.
Mesh make_shell_sheet(std::uint32_t n);

/// A cube of n x n x n unit cells of six tetrahedra each.
Mesh make_tet_cube(std::uint32_t n);

/// A closed surface of quadrilaterals.
struct QuadSurface {
  Eigen::Matrix3Xd positions;                       ///< 3 x n_nodes [length]
  std::vector<std::array<std::uint32_t, 4>> quads;  ///< [n_quads] nodes, anticlockwise seen from outside
};

/// A sphere around the origin: a cube of n x n faces a side blown up, its edges of nearly equal length.
///   radius  [length]
///   noise   by how much nodes are moved at random, the same in every run, along each axis at most [length]
QuadSurface make_cubed_sphere(std::uint32_t n, double radius, double noise);

/// Two concentric cubed spheres as contact sees them: inner and outer of 6 n^2 faces each, mean edge 1, the
/// gap a tenth of it, nodes moved by 2 % of it.
struct SpherePair {
  QuadSurface inner, outer;
};
SpherePair make_sphere_pair(std::uint32_t n);

/// Turns a surface about the oblique axis (1, 2, 3).
///   angle  [1] (radians)
void turn(QuadSurface& surface, double angle);

}  // namespace contactsim::bench
