// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace contactsim {

/// Element shapes that contactsim can tell apart. `unknown` is kept so that a mesh may hold
/// blocks that nothing uses.
enum class Shape : std::uint8_t {
  hex8,
  hex20,
  hex27,
  tet4,
  tet10,
  wedge6,
  wedge15,
  pyramid5,
  pyramid13,
  shell4,
  shell8,
  shell9,
  shell3,
  shell6,
  quad4,
  quad8,
  quad9,
  bar2,
  bar3,
  beam2,
  beam3,
  sphere,
  cohesive8,  ///< HEX8 and WEDGE6 of a block that a deck makes cohesive: see Mesh::with_cohesive_blocks
  cohesive6,
  null,
  unknown
};

/// What an element is to contact: solids are skinned, shells, lines and particles lofted; cohesive elements
/// are as if absent.
enum class Family : std::uint8_t { solid, shell, line, particle, cohesive, none };

enum class SideKind : std::uint8_t { face, edge, node };

/// One side of an element shape by its corner nodes, in outward right-hand order for faces.
struct Side {
  SideKind kind = SideKind::face;
  std::uint8_t n_corners = 0;  ///< 4 or 3 for faces, 2 for edges, 1 for nodes
  std::array<std::uint8_t, 4>
      corners{};  ///< positions in the element's connectivity, from 0; unused ones repeat the last
};

/// A flat or bilinear piece of a face by positions in the element's connectivity, from 0, in the order of its
/// face; a triangle repeats its last.
using FacetCorners = std::array<std::uint8_t, 4>;

/// A face of six nodes: the triangles at its corners, then that between the midside nodes.
using SplitFace = std::array<FacetCorners, 4>;

/// Fixed facts of one shape. Source: Exodus II side numbering (Sandia report SAND92-2137, chapter 4).
struct Topology {
  Shape shape = Shape::unknown;
  std::string_view name;  ///< upper case, as written to Exodus: "HEX8"
  Family family = Family::none;
  std::uint8_t n_nodes = 0;  ///< columns of the connectivity
  std::uint8_t n_corners = 0;
  std::span<const Side> sides;  ///< side s of Exodus is sides[s - 1]
  /// As sides, of shapes whose midside nodes move the faces; of others empty: each side is one facet.
  std::span<const SplitFace> split_faces = {};

  /// The facets of a side.
  ///   side  position in sides
  std::span<const FacetCorners> facets(std::size_t side) const {
    if (split_faces.empty()) return {&sides[side].corners, 1};
    return split_faces[side];
  }
  /// Nodes that the volume depends on: the first so many.
  std::size_t n_shape_nodes() const { return split_faces.empty() ? n_corners : n_nodes; }
};

/// The facts of a shape; every shape has a row.
const Topology& topology(Shape shape);

/// The shape that an Exodus element type name and a number of nodes per element mean, compared without case,
/// blanks and trailing digits; the number of columns decides between variants. `Shape::unknown` when none
/// fits. A TRI block of a three-dimensional mesh is a shell; a QUAD block is one too, but its sides are its
/// edges.
Shape find_shape(std::string_view type_name, int n_nodes_per_element);

}  // namespace contactsim
