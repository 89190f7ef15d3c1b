// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "support/mesh_builder.hpp"

/// Random meshes and contact definitions, the same for the same random numbers.
namespace contactsim::test {

using Random = std::mt19937;

/// Side sets 1 to 4 of random faces of solids, interior ones too, and node sets 1 and 2 of random nodes.
///   n_solid_blocks  blocks 1 to this are solids
inline void add_random_sets(MeshBuilder& b, Random& random, std::int64_t n_solid_blocks) {
  for (const std::int64_t id : {1, 2, 3, 4}) {
    b.add_side_set(id, "",
                   [&](const CandidateSide& c) { return c.block_id <= n_solid_blocks && random() % 4 == 0; });
  }
  b.add_node_set(1, "", [&](const Eigen::Vector3d&) { return random() % 3 == 0; });
  b.add_node_set(2, "", [&](const Eigen::Vector3d&) { return random() % 3 == 0; });
}

/// A brick of three blocks that share nodes, wedges and tetrahedra on its sides, shells on part of its top,
/// beams above it. Blocks 1 to 7 and random sets.
inline MeshBuilder random_mesh(Random& random) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 3, 2}, .size = {2, 3, 2}});
  b.add_hexes({.id = 2, .cells = {2, 3, 1}, .origin = {2, 0, 0}, .size = {2, 3, 1}});
  b.add_hexes({.id = 3, .cells = {2, 3, 1}, .origin = {2, 0, 1}, .size = {2, 3, 1}});
  b.add_wedges({.id = 4, .cells = {1, 2, 2}, .origin = {-1, 0, 0}, .size = {1, 2, 2}});
  b.add_tets({.id = 5, .cells = {2, 1, 1}, .origin = {0, 3, 0}, .size = {2, 1, 1}}, 5);
  b.add_shells({.id = 6, .cells = {3, 2}, .origin = {0, 0, 2}, .u = {3, 0, 0}, .v = {0, 2, 0}});
  b.add_beams({.id = 7, .cells = 3, .from = {0, 0, 4}, .to = {3, 0, 4}});
  add_random_sets(b, random, 5);
  return b;
}

/// 4 x 3 x 3 hexahedra and the 4 x 3 shells on their top, dealt out at random: hexahedra to the blocks 1 to
/// 5, shells to 6 and 7. Random sets.
inline MeshBuilder random_blocking(Random& random) {
  constexpr std::uint32_t nx = 4, ny = 3, nz = 3, width = nx + 1, layer = width * (ny + 1);
  MeshBuilder b;
  for (std::uint32_t i = 0; i < layer * (nz + 1); ++i)
    b.add_node({double(i % width), double(i / width % (ny + 1)), double(i / layer)});
  std::array<std::vector<std::uint32_t>, 8> nodes;  // of the blocks with these ids
  for (std::uint32_t cell = 0; cell < nx * ny * (nz + 1); ++cell) {
    const std::uint32_t n = cell % nx + width * (cell / nx % ny) + layer * (cell / (nx * ny));
    const bool is_shell = cell >= nx * ny * nz;
    auto& block = nodes[is_shell ? 6 + random() % 2 : 1 + random() % 5];
    block.insert(block.end(), {n, n + 1, n + width + 1, n + width});
    if (is_shell) continue;
    const std::uint32_t m = n + layer;
    block.insert(block.end(), {m, m + 1, m + width + 1, m + width});
  }
  for (std::int64_t id = 1; id <= 7; ++id)
    b.add_block(id, "", id <= 5 ? Shape::hex8 : Shape::shell4, nodes[static_cast<std::size_t>(id)]);
  add_random_sets(b, random, 5);
  return b;
}

/// Either of the two.
inline MeshBuilder random_mesh_or_blocking(Random& random) {
  return random() % 2 == 0 ? random_mesh(random) : random_blocking(random);
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

/// A mesh of all that ownership tells apart: one of the above, with particles (block 8) and a hexahedron that
/// is degenerate to a wedge beside the first element (block 9). surface_5: some faces of shells and of that
/// hexahedron, collapsed ones too.
inline Mesh random_mesh_of_all_kinds(Random& random) {
  MeshBuilder b = random_mesh_or_blocking(random);
  b.add_spheres(8, "", {{0, 0, 6}, {1, 0, 6}, {3, 0, 4}});
  const Mesh before = b.build();
  const auto node = [&](std::size_t corner) { return before.element_nodes({0})[corner].value; };
  const std::uint32_t p = b.add_node({9, 0, 0}).value, q = b.add_node({9, 0, 1}).value;
  b.add_block(9, "", Shape::hex8, {node(1), p, p, node(2), node(5), q, q, node(6)});
  b.add_side_set(5, "", [&](const CandidateSide& c) { return c.block_id >= 6 && random() % 3 == 0; });
  return b.build();
}

inline std::string join(const std::vector<std::string>& lines) {
  return std::accumulate(lines.begin(), lines.end(), std::string());
}

/// For such a mesh random_lines() and commands with subsets, removed parts, single shells and, at times, a
/// subdomain.
inline std::string random_commands(const Mesh& mesh, Random& random) {
  std::vector<std::string> lines = random_lines(random);
  lines.push_back(
      "begin contact surface with_subsets\n block = block_1 block_3 block_6 block_9\n"
      " subset up with normal 0 0 1\n subset right with normal 1 0 0\n remove surface = surface_2\nend\n");
  lines.push_back("begin contact surface of_all\n include all blocks\n remove block = block_2\nend\n");
  lines.push_back("contact surface of_shells contains surface_5 block_6 block_8\n");
  lines.push_back("contact node set of_blocks contains block_1 surface_3\n");
  std::string picked = "begin contact surface of_elements\n remove surface = surface_5\n element =";
  for (const ElementBlock& block : mesh.blocks()) {
    for (std::uint32_t i = 0; (block.id == 6 || block.id == 7) && i < block.n_elements; ++i) {
      if (random() % 2 == 0) picked += fmt::format(" {}", mesh.element_id({block.first_element.value + i}));
    }
  }
  if (picked.back() != '=') lines.push_back(picked + "\nend\n");
  std::shuffle(lines.begin(), lines.end(), random);
  lines.resize(3 + random() % (lines.size() - 3));
  const auto domain = random() % 6;
  if (domain < 2) lines.push_back("restrict contact to subdomain defined by radius 2.6 and point 1 1 1\n");
  if (domain == 2) lines.push_back("restrict contact to box defined by -0.5 0 2 and 3 2.6 -0.5\n");
  return join(lines);
}

}  // namespace contactsim::test
