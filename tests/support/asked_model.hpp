// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// Elements: 1 a hexahedron, 2 a shell, 3 a beam, 4 a particle. Names on the mesh: block_1 plate, side set 10
/// plate as well, block 2 skin, block_3, block 4 dust, node set 20 corners.
inline MeshBuilder asked_model() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "plate"});
  b.add_shells({.id = 2, .name = "skin", .origin = {0, 0, 5}});
  b.add_beams({.id = 3, .from = {0, 7, 0}, .to = {1, 7, 0}});
  b.add_spheres(4, "dust", {{0, 9, 0}});
  b.add_side_set(10, "plate", {{{0}, 6}});
  b.add_side_set(11, "edge", {{{1}, 1}, {{1}, 4}});
  b.add_side_set(12, "tip", {{{2}, 1}});
  b.add_node_set(20, "corners", {0, 1});
  b.add_assembly(30, "mixed", EntityKind::block, {1, 4});
  b.add_assembly(31, "points", EntityKind::node_set, {20});
  b.add_assembly(32, "nothing", EntityKind::block, {});
  b.add_assembly(33, "tops", EntityKind::side_set, {10});
  return b;
}

}  // namespace contactsim::test
