// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dynamics/model.hpp"

namespace contactsim {

/// Positions from `begin` on, before `end`.
struct ChunkRange {
  std::size_t begin = 0, end = 0;

  std::size_t size() const { return end - begin; }
  bool contains(std::size_t chunk) const { return begin <= chunk && chunk < end; }
};

/// Which chunks of elements each rank advances: of all chunks, block after block, a range of about an equal
/// part of the work. A chunk is the unit, since what it adds to its nodes is a sum of its own.
class ChunkShares {
 public:
  ///   blocks   of the model
  ///   n_ranks  > 0
  ChunkShares(std::span<const ModelBlock> blocks, int n_ranks);

  int n_ranks() const { return static_cast<int>(begins_.size()) - 1; }
  /// The chunks of a block that a rank has.
  ChunkRange of(int rank, std::size_t block) const;
  /// Where the chunks of each rank begin [n_ranks + 1] of all chunks.
  std::span<const std::size_t> begins() const { return begins_; }
  /// Chunks of the blocks before.
  std::size_t first_chunk(std::size_t block) const { return first_chunk_[block]; }
  /// The share of the work that the busiest rank has beyond an equal one [1].
  double imbalance() const { return imbalance_; }

 private:
  std::vector<std::size_t> first_chunk_;  // [n_blocks + 1] of all chunks
  std::vector<std::size_t> begins_;       // [n_ranks + 1] of all chunks
  double imbalance_ = 0.0;
};

/// The rank that advances each element of the mesh [n_elements]; of what none advances the first.
std::vector<std::uint32_t> find_ranks_of_elements(const Model& model, int n_ranks);

}  // namespace contactsim
