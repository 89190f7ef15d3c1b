// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <initializer_list>

#include "core/base/prefetch.hpp"
#include "core/elements/model_block.hpp"

namespace contactsim::batches {

/// Has the memory of what comes after a batch fetched while that is worked on: what the next batch remembers,
/// and this batch's share of the nodes of the next chunk.
///   values  at the nodes of the mesh, [3 x n_nodes] each
[[gnu::always_inline]] inline void fetch_ahead(const ModelBlock& block, const BatchChunk& chunk,
                                               std::size_t batch, const ModelBlockState& state,
                                               std::initializer_list<const Eigen::Matrix3Xd*> values) {
  if (batch + 1 == block.n_batches()) return;
  const std::size_t size = block.layout.size();
  for (std::size_t i = (batch + 1) * size; i < (batch + 2) * size; ++i) prefetch(state.values[i]);
  const std::size_t n_nodes = (chunk.n_nodes + chunk.n_batches - 1) / chunk.n_batches;
  const std::size_t begin = chunk.first_node + chunk.n_nodes + (batch - chunk.first_batch) * n_nodes;
  const std::size_t end = std::min(begin + n_nodes, block.chunk_nodes.size());
  for (std::size_t i = begin; i < end; ++i) {
    __builtin_prefetch(&state.forces[i], 1, 2);
    for (const Eigen::Matrix3Xd* vectors : values)
      __builtin_prefetch(vectors->data() + 3 * static_cast<std::size_t>(block.chunk_nodes[i]), 0, 2);
  }
}

}  // namespace contactsim::batches
