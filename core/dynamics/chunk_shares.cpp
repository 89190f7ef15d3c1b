// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/chunk_shares.hpp"

#include <algorithm>

#include "core/elements/element_table.hpp"

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
  double all = 0.0;
  first_chunk_.push_back(0);
  for (const ModelBlock& block : blocks) {
    for (const BatchChunk& chunk : block.chunks) {
      costs.push_back(cost_of_batch(block) * static_cast<double>(chunk.n_batches));
      all += costs.back();
    }
    first_chunk_.push_back(costs.size());
  }
  begins_.assign(static_cast<std::size_t>(n_ranks) + 1, costs.size());
  begins_.front() = 0;
  double so_far = 0.0, largest = 0.0, of_rank = 0.0;
  std::size_t rank = 1;
  for (std::size_t chunk = 0; chunk < costs.size(); ++chunk) {
    // The rank ends where its end is nearest to its part of the work.
    while (rank < begins_.size() - 1 &&
           so_far + 0.5 * costs[chunk] >= all * static_cast<double>(rank) / static_cast<double>(n_ranks)) {
      begins_[rank++] = chunk;
      largest = std::max(largest, of_rank);
      of_rank = 0.0;
    }
    so_far += costs[chunk];
    of_rank += costs[chunk];
  }
  largest = std::max(largest, of_rank);
  if (all > 0.0) imbalance_ = largest * static_cast<double>(n_ranks) / all - 1.0;
}

ChunkRange ChunkShares::of(int rank, std::size_t block) const {
  const auto r = static_cast<std::size_t>(rank);
  const std::size_t first = first_chunk_[block], end = first_chunk_[block + 1];
  const auto in_block = [&](std::size_t chunk) { return std::clamp(chunk, first, end) - first; };
  return {in_block(begins_[r]), in_block(begins_[r + 1])};
}

}  // namespace contactsim
