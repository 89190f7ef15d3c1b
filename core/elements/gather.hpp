// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <span>

#include "core/base/tensor_lanes.hpp"

/// Between nodes and lanes. The vectors of nodes stand in fours here, x y z and a number that means nothing,
/// so that one load takes a vector and eight of them make three Lanes by shuffles alone.
namespace contactsim {

using NodeVector = Eigen::Vector4d;

/// Position of a node in the chunk of elements that it belongs to.
using ChunkNode = std::uint16_t;

/// The compiler's own vectors, for shuffles that Eigen has no word for.
using Eight [[gnu::vector_size(8 * sizeof(double))]] = double;
using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

/// The vectors at the nodes of eight elements.
///   nodes   [n x n_lanes]
///   values  [n_nodes of the chunk]
template <std::size_t n>
NodeVectors<n> gather(const ChunkNode* nodes, const NodeVector* values) {
  NodeVectors<n> gathered;
  for (std::size_t node = 0; node < n; ++node, nodes += n_lanes) {
    Four v[n_lanes];
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      std::memcpy(&v[lane], values[nodes[lane]].data(), sizeof(Four));
    Eight pairs[4];  // of neighbouring lanes: x y z . x y z .
    for (std::size_t k = 0; k < 4; ++k)
      pairs[k] = __builtin_shufflevector(v[2 * k], v[2 * k + 1], 0, 1, 2, 3, 4, 5, 6, 7);
    const auto store = [&](std::size_t i, const Four& first, const Four& last) {
      const Eight lanes = __builtin_shufflevector(first, last, 0, 1, 2, 3, 4, 5, 6, 7);
      std::memcpy(gathered[i][node].data(), &lanes, sizeof(Eight));
    };
    store(0, __builtin_shufflevector(pairs[0], pairs[1], 0, 4, 8, 12),
          __builtin_shufflevector(pairs[2], pairs[3], 0, 4, 8, 12));
    store(1, __builtin_shufflevector(pairs[0], pairs[1], 1, 5, 9, 13),
          __builtin_shufflevector(pairs[2], pairs[3], 1, 5, 9, 13));
    store(2, __builtin_shufflevector(pairs[0], pairs[1], 2, 6, 10, 14),
          __builtin_shufflevector(pairs[2], pairs[3], 2, 6, 10, 14));
  }
  return gathered;
}

/// The vectors of one node of eight elements, lane by lane.
inline std::array<NodeVector, n_lanes> split_lanes(const Lanes& x, const Lanes& y, const Lanes& z) {
  Eight ex, ey, ez;
  std::memcpy(&ex, x.data(), sizeof(Eight));
  std::memcpy(&ey, y.data(), sizeof(Eight));
  std::memcpy(&ez, z.data(), sizeof(Eight));
  const Eight zero{};
  const Eight even_xy = __builtin_shufflevector(ex, ey, 0, 8, 2, 10, 4, 12, 6, 14);
  const Eight odd_xy = __builtin_shufflevector(ex, ey, 1, 9, 3, 11, 5, 13, 7, 15);
  const Eight even_z = __builtin_shufflevector(ez, zero, 0, 8, 2, 10, 4, 12, 6, 14);
  const Eight odd_z = __builtin_shufflevector(ez, zero, 1, 9, 3, 11, 5, 13, 7, 15);
  std::array<NodeVector, n_lanes> vectors;
  const auto store = [&](std::size_t lane, const Four& vector) {
    std::memcpy(vectors[lane].data(), &vector, sizeof(Four));
  };
  store(0, __builtin_shufflevector(even_xy, even_z, 0, 1, 8, 9));
  store(1, __builtin_shufflevector(odd_xy, odd_z, 0, 1, 8, 9));
  store(2, __builtin_shufflevector(even_xy, even_z, 2, 3, 10, 11));
  store(3, __builtin_shufflevector(odd_xy, odd_z, 2, 3, 10, 11));
  store(4, __builtin_shufflevector(even_xy, even_z, 4, 5, 12, 13));
  store(5, __builtin_shufflevector(odd_xy, odd_z, 4, 5, 12, 13));
  store(6, __builtin_shufflevector(even_xy, even_z, 6, 7, 14, 15));
  store(7, __builtin_shufflevector(odd_xy, odd_z, 6, 7, 14, 15));
  return vectors;
}

/// Adds the vectors at the nodes of eight elements up at the nodes, one element after another.
///   n_used  elements that count, from the front
template <std::size_t n>
void scatter_add(const NodeVectors<n>& vectors, const ChunkNode* nodes, std::size_t n_used,
                 NodeVector* sums) {
  for (std::size_t node = 0; node < n; ++node, nodes += n_lanes) {
    const auto split = split_lanes(vectors[0][node], vectors[1][node], vectors[2][node]);
    for (std::size_t lane = 0; lane < n_used; ++lane) sums[nodes[lane]] += split[lane];
  }
}

}  // namespace contactsim
