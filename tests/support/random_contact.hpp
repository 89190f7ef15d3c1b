// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "support/mesh_builder.hpp"

/// Random meshes and contact definitions, the same for the same random numbers.
namespace contactsim::test {

using Random = std::mt19937;

/// A brick of three blocks that share nodes, one of them of two parts, tetrahedra and wedges on its sides,
/// shells on part of its top, beams, particles, and random side sets of solid faces, interior ones too.
/// Blocks 1 to 7, side sets 1 to 4, node sets 1 and 2.
inline MeshBuilder random_mesh(Random& random) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 3, 2}, .size = {2, 3, 2}});
  b.add_hexes({.id = 2, .cells = {2, 3, 1}, .origin = {2, 0, 0}, .size = {2, 3, 1}});
  b.add_hexes({.id = 3, .cells = {2, 3, 1}, .origin = {2, 0, 1}, .size = {2, 3, 1}});
  b.add_wedges({.id = 4, .cells = {1, 2, 2}, .origin = {-1, 0, 0}, .size = {1, 2, 2}});
  b.add_tets({.id = 5, .cells = {2, 1, 1}, .origin = {0, 3, 0}, .size = {2, 1, 1}}, 5);
  b.add_shells({.id = 6, .cells = {3, 2}, .origin = {0, 0, 2}, .u = {3, 0, 0}, .v = {0, 2, 0}});
  b.add_beams({.id = 7, .cells = 3, .from = {0, 0, 4}, .to = {3, 0, 4}});
  for (const std::int64_t id : {1, 2, 3, 4}) {
    b.add_side_set(id, "", [&](const CandidateSide& c) { return c.block_id < 6 && random() % 4 == 0; });
  }
  b.add_node_set(1, "", [&](const Eigen::Vector3d&) { return random() % 3 == 0; });
  b.add_node_set(2, "", [&](const Eigen::Vector3d&) { return random() % 3 == 0; });
  return b;
}

/// Lines of CONTACT SURFACE (s0, s1, ...) and CONTACT NODE SET (n0, ...) with random items, in random order.
inline std::vector<std::string> random_lines(Random& random) {
  std::vector<std::string> lines;
  for (int i = 0; i < 5; ++i) {
    std::string line = fmt::format("contact surface s{} contains", i);
    const auto n_items = 1 + random() % 3;
    for (std::size_t item = 0; item < n_items; ++item)
      line += random() % 3 == 0 ? fmt::format(" surface_{}", 1 + random() % 4)
                                : fmt::format(" block_{}", 1 + random() % 7);
    lines.push_back(line + "\n");
  }
  lines.push_back("contact node set n0 contains nodelist_1 surface_1\n");
  lines.push_back("contact node set n1 contains nodelist_2 block_7\n");
  std::shuffle(lines.begin(), lines.end(), random);
  return lines;
}

inline std::string join(const std::vector<std::string>& lines) {
  return std::accumulate(lines.begin(), lines.end(), std::string());
}

}  // namespace contactsim::test
