// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// A cube with corners from (1 1 1) to (2 2 2), its nodes also in sets n1 to n8.
inline Mesh constrained_cube() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .origin = {1, 1, 1}});
  for (std::uint32_t i = 0; i < 8; ++i)
    b.add_node_set(i + 1, "n" + std::to_string(i + 1), std::vector<std::uint32_t>{i});
  return b.build();
}

/// The lines of a condition of a region.
inline std::string condition_block(const std::string& kind, const std::string& lines) {
  return "begin " + kind + "\n" + lines + "\nend\n";
}

}  // namespace contactsim::test
