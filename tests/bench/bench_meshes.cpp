// SPDX-License-Identifier: BSD-3-Clause
#include "bench_meshes.hpp"

#include <algorithm>
#include <numeric>
#include <random>

namespace contactsim::bench {

namespace {

/// The corners of the cell i, j, k in a grid of n cells along each edge, in HEX8 order.
std::array<NodeIndex, 8> cell_corners(std::uint32_t n, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  const auto node = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return NodeIndex{(i + a) + (n + 1) * ((j + b) + (n + 1) * (k + c))};
  };
  return {node(0, 0, 0), node(1, 0, 0), node(1, 1, 0), node(0, 1, 0),
          node(0, 0, 1), node(1, 0, 1), node(1, 1, 1), node(0, 1, 1)};
}

ElementBlock make_block(std::uint32_t n, std::array<std::uint32_t, 3> first, std::uint32_t n_cells,
                        bool shuffled) {
  ElementBlock block;
  block.shape = Shape::hex8;
  block.type_name = "HEX8";
  block.nodes_per_element = 8;
  block.n_elements = n_cells * n_cells * n_cells;
  block.nodes.reserve(std::size_t{8} * block.n_elements);
  std::vector<std::uint32_t> order(block.n_elements);
  std::iota(order.begin(), order.end(), 0u);
  if (shuffled) std::shuffle(order.begin(), order.end(), std::mt19937(1));
  for (const std::uint32_t cell : order) {
    const std::uint32_t i = cell % n_cells, j = cell / n_cells % n_cells, k = cell / n_cells / n_cells;
    const auto corners = cell_corners(n, first[0] + i, first[1] + j, first[2] + k);
    block.nodes.insert(block.nodes.end(), corners.begin(), corners.end());
  }
  return block;
}

/// The nodes of a grid of unit cells.
MeshParts make_grid(std::uint32_t n) {
  MeshParts parts;
  parts.path = "cube";
  parts.coordinates.resize(3, static_cast<Eigen::Index>(n + 1) * (n + 1) * (n + 1));
  for (Eigen::Index node = 0; node < parts.coordinates.cols(); ++node) {
    const Eigen::Index row = n + 1;
    parts.coordinates.col(node) =
        Eigen::Array<Eigen::Index, 3, 1>(node % row, node / row % row, node / row / row)
            .cast<double>()
            .matrix();
  }
  return parts;
}

}  // namespace

Mesh make_tet_cube(std::uint32_t n) {
  // The six ways from corner 0 along edges to corner 6.
  constexpr std::size_t ways[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                      {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  MeshParts parts = make_grid(n);
  ElementBlock block;
  block.id = 1;
  block.shape = Shape::tet4;
  block.type_name = "TETRA4";
  block.nodes_per_element = 4;
  block.n_elements = 6 * n * n * n;
  for (std::uint32_t cell = 0; cell < n * n * n; ++cell) {
    const auto corners = cell_corners(n, cell % n, cell / n % n, cell / n / n);
    for (const auto& way : ways) {
      for (const std::size_t corner : way) block.nodes.push_back(corners[corner]);
    }
  }
  parts.blocks.push_back(std::move(block));
  return Mesh(std::move(parts));
}

Mesh make_hex_cube(std::uint32_t n, std::uint32_t n_blocks, bool shuffled) {
  MeshParts parts = make_grid(n);
  const std::uint32_t n_cells = n / n_blocks;
  for (std::uint32_t b = 0; b < n_blocks * n_blocks * n_blocks; ++b) {
    const std::array<std::uint32_t, 3> first{b % n_blocks * n_cells, b / n_blocks % n_blocks * n_cells,
                                             b / n_blocks / n_blocks * n_cells};
    parts.blocks.push_back(make_block(n, first, n_cells, shuffled));
    parts.blocks.back().id = b + 1;
  }
  return Mesh(std::move(parts));
}

}  // namespace contactsim::bench
