// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/chunk_shares.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/elements/element_table.hpp"
#include "core/parallel/equal_shares.hpp"

namespace contactsim {

namespace {

/// What a batch of elements costs, in those of a solid of one integration point: measured, selective
/// deviatoric hexahedra with eight points cost 2.5 times as much, shells of five layers twice.
double cost_of_batch(const ModelBlock& block) {
  constexpr double of_point = 0.22;
  if (block.is_rigid) return 0.0;
  const double n_points = static_cast<double>(std::max<std::size_t>(block.layout.n_points, 1));
  return 1.0 - of_point + of_point * n_points;
}

}  // namespace

ChunkShares::ChunkShares(std::span<const ModelBlock> blocks, int n_ranks) {
  std::vector<double> costs;
  first_chunk_.push_back(0);
  for (const ModelBlock& block : blocks) {
    for (const BatchChunk& chunk : block.chunks) {
      // Every rank advances what is subcycled.
      costs.push_back(chunk.is_subcycled ? 0.0 : cost_of_batch(block) * static_cast<double>(chunk.n_batches));
    }
    first_chunk_.push_back(costs.size());
  }
  begins_ = equal_shares(costs, n_ranks);
  const double all = std::accumulate(costs.begin(), costs.end(), 0.0);
  double largest = 0.0;
  for (std::size_t rank = 0; rank + 1 < begins_.size(); ++rank) {
    const auto own = std::span(costs).subspan(begins_[rank], begins_[rank + 1] - begins_[rank]);
    largest = std::max(largest, std::accumulate(own.begin(), own.end(), 0.0));
  }
  if (all > 0.0) imbalance_ = largest * static_cast<double>(n_ranks) / all - 1.0;
}

ChunkRange ChunkShares::of(int rank, std::size_t block) const {
  const auto r = static_cast<std::size_t>(rank);
  const std::size_t first = first_chunk_[block], end = first_chunk_[block + 1];
  const auto in_block = [&](std::size_t chunk) { return std::clamp(chunk, first, end) - first; };
  return {in_block(begins_[r]), in_block(begins_[r + 1])};
}

std::vector<std::uint32_t> find_ranks_of_elements(const Model& model, int n_ranks) {
  const ChunkShares shares(model.blocks, n_ranks);
  std::vector<std::uint32_t> ranks(model.mesh->n_elements(), 0);
  for (int rank = 0; rank < n_ranks; ++rank) {
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      const ModelBlock& block = model.blocks[b];
      const ChunkRange own = shares.of(rank, b);
      for (std::size_t c = own.begin; c < own.end; ++c) {
        const BatchChunk& chunk = block.chunks[c];
        const std::size_t begin = chunk.first_batch * n_lanes;
        const std::size_t end = std::min((chunk.first_batch + chunk.n_batches) * n_lanes, block.n_elements);
        std::fill(ranks.begin() + static_cast<std::ptrdiff_t>(block.first_element.value + begin),
                  ranks.begin() + static_cast<std::ptrdiff_t>(block.first_element.value + end),
                  static_cast<std::uint32_t>(rank));
      }
    }
  }
  return ranks;
}

}  // namespace contactsim
