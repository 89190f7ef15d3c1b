// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/chunk_shares.hpp"

#include "core/elements/element_table.hpp"
#include "core/elements/elements.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A block of whole chunks and a last one of some batches.
ModelBlock block_of_chunks(std::size_t n_whole, std::size_t n_left) {
  ModelBlock block;
  block.element = &hex8_mean_quadrature;
  block.layout.n_points = 1;
  for (std::size_t i = 0; i < n_whole; ++i)
    block.chunks.push_back({i * ModelBlock::batches_per_chunk, ModelBlock::batches_per_chunk, 0, 0});
  if (n_left > 0) block.chunks.push_back({n_whole * ModelBlock::batches_per_chunk, n_left, 0, 0});
  return block;
}

}  // namespace

TEST_CASE("equal chunks are shared equally, in their order", "[core][chunk_shares]") {
  const std::vector<ModelBlock> blocks{block_of_chunks(5, 0), block_of_chunks(7, 0)};
  const ChunkShares shares(blocks, 3);
  CHECK(shares.of(0, 0).size() == 4);
  CHECK(shares.of(0, 1).size() == 0);
  CHECK(shares.of(1, 0).begin == 4);
  CHECK(shares.of(1, 0).end == 5);
  CHECK(shares.of(1, 1).end == 3);
  CHECK(shares.of(2, 1).begin == 3);
  CHECK(shares.of(2, 1).end == 7);
  CHECK(shares.first_chunk(1) == 5);
  CHECK(shares.imbalance() == Approx(0.0).margin(1e-15));
}

TEST_CASE("every chunk has one rank, also where there are fewer chunks than ranks", "[core][chunk_shares]") {
  for (const int n_ranks : {1, 2, 3, 8, 20}) {
    const std::vector<ModelBlock> blocks{block_of_chunks(0, 3), block_of_chunks(4, 10),
                                         block_of_chunks(0, 1)};
    const ChunkShares shares(blocks, n_ranks);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      std::size_t next = 0;
      for (int rank = 0; rank < n_ranks; ++rank) {
        const ChunkRange range = shares.of(rank, b);
        CHECK(range.begin == next);
        next = range.end;
      }
      CHECK(next == blocks[b].chunks.size());
    }
  }
}

TEST_CASE("a block of more points has more of the ranks, a rigid one none", "[core][chunk_shares]") {
  std::vector<ModelBlock> blocks{block_of_chunks(10, 0), block_of_chunks(10, 0), block_of_chunks(10, 0)};
  blocks[0].is_rigid = true;
  blocks[1].layout.n_points = 8;
  const ChunkShares shares(blocks, 2);
  // Eight points cost 1 + 7 x 0.22 = 2.54: half of all, 17.7 chunks of one point, is reached by 7 of these.
  CHECK(shares.of(0, 0).size() == 10);
  CHECK(shares.of(0, 1).size() == 7);
  CHECK(shares.of(1, 1).size() == 3);
  CHECK(shares.of(1, 2).size() == 10);
  CHECK(shares.imbalance() == Approx(7 * 2.54 / 17.7 - 1.0));
}
