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
  null,
  unknown
};

/// What an element is to contact: solids are skinned, the rest are lofted.
enum class Family : std::uint8_t { solid, shell, line, particle, none };

enum class SideKind : std::uint8_t { face, edge, node };

/// One side of an element shape by its corner nodes, in outward right-hand order for faces.
struct Side {
  SideKind kind = SideKind::face;
  std::uint8_t n_corners = 0;  ///< 4 or 3 for faces, 2 for edges, 1 for nodes
  std::array<std::uint8_t, 4>
      corners{};  ///< positions in the element's connectivity, from 0; unused ones repeat the last
};

/// Fixed facts of one shape. Source: Exodus II side numbering (Sandia report SAND92-2137, chapter 4).
struct Topology {
  Shape shape = Shape::unknown;
  std::string_view name;  ///< upper case, as written to Exodus: "HEX8"
  Family family = Family::none;
  std::uint8_t n_nodes = 0;  ///< columns of the connectivity
  std::uint8_t n_corners = 0;
  std::span<const Side> sides;  ///< side s of Exodus is sides[s - 1]
};

/// The facts of a shape; every shape has a row.
const Topology& topology(Shape shape);

/// The shape that an Exodus element type name and a number of nodes per element mean, compared without case,
/// blanks and trailing digits; the number of columns decides between variants. `Shape::unknown` when none
/// fits. A TRI block of a three-dimensional mesh is a shell; a QUAD block is one too, but its sides are its
/// edges.
Shape find_shape(std::string_view type_name, int n_nodes_per_element);

}  // namespace contactsim
