// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// A plate of 3 x 3 x 1 cells of size 1 x 1 x 0.5, and a tetrahedron far away.
inline MeshBuilder plate_and_tet() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 0.5}});
  const std::uint32_t first = b.add_node({9, 0, 0}).value;
  b.add_node({10, 0, 0});
  b.add_node({9, 1, 0});
  b.add_node({9, 0, 3});
  b.add_block(2, "", Shape::tet4, {first, first + 1, first + 2, first + 3});
  b.add_side_set(1, "top", [](const CandidateSide& c) { return c.block_id == 1 && c.centroid.z() == 0.5; });
  b.add_side_set(2, "floor", [](const CandidateSide& c) { return c.block_id == 2 && c.centroid.z() == 0.0; });
  b.add_node_set(1, "tips", [](const Eigen::Vector3d& x) { return x.z() == 3.0 || x.x() == 0.0; });
  return b;
}

/// The top of the plate, the floor of the tetrahedron, the nodes at x = 0 with the tip of the tetrahedron.
inline const std::string plate_and_tet_surfaces =
    "contact surface a contains top\ncontact surface b contains floor\n"
    "contact node set n contains tips\n";

}  // namespace contactsim::test
