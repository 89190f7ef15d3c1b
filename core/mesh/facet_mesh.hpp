// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace contactsim {

/// The facets of one surface, to be drawn.
struct FacetBlock {
  std::string name;
  std::vector<std::array<std::uint32_t, 4>>
      facets;                         ///< columns of FacetMesh::coordinates; a triangle repeats its last
  std::vector<std::uint32_t> points;  ///< columns of FacetMesh::coordinates, of surfaces of nodes
  std::vector<std::array<std::uint32_t, 2>> edges = {};  ///< the same, of edges that meet edges
};

/// Surfaces as a mesh of their own. The facets of a block are all quadrilaterals and triangles, or all
/// points, or all edges.
struct FacetMesh {
  Eigen::Matrix3Xd coordinates;  ///< 3 x n [length]
  std::vector<FacetBlock> blocks;
};

}  // namespace contactsim
