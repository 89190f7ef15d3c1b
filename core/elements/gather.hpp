// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "core/lanes.hpp"

/// Between nodes and lanes. The vectors of nodes stand in fours here, x y z and a number that means nothing,
/// so that one load takes a vector and eight of them make three Lanes by shuffles alone.
namespace contactsim {

using NodeVector = Eigen::Vector4d;

/// Position of a node in the chunk of elements that it belongs to.
using ChunkNode = std::uint16_t;

/// The vectors at the nodes of eight elements.
///   nodes   [n x n_lanes]
///   values  [n_nodes of the chunk]
template <std::size_t n>
NodeVectors<n> gather(const ChunkNode* nodes, const NodeVector* values) {
  NodeVectors<n> gathered;
  for (std::size_t node = 0; node < n; ++node) {
    Eigen::Matrix<double, 4, n_lanes> columns;
    for (int lane = 0; lane < n_lanes; ++lane) columns.col(lane) = values[nodes[node * n_lanes + lane]];
    for (std::size_t i = 0; i < 3; ++i)
      gathered[i][node] = columns.row(static_cast<Eigen::Index>(i)).transpose().array();
  }
  return gathered;
}

/// Adds the vectors at the nodes of eight elements up at the nodes, one element after another.
///   n_used  elements that count, from the front
template <std::size_t n>
void scatter_add(const NodeVectors<n>& vectors, const ChunkNode* nodes, int n_used, NodeVector* sums) {
  for (std::size_t node = 0; node < n; ++node) {
    for (int lane = 0; lane < n_used; ++lane) {
      sums[nodes[node * n_lanes + static_cast<std::size_t>(lane)]] +=
          NodeVector(vectors[0][node](lane), vectors[1][node](lane), vectors[2][node](lane), 0.0);
    }
  }
}

}  // namespace contactsim
