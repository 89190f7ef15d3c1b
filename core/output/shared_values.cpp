// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/shared_values.hpp"

#include <algorithm>
#include <vector>

#include "core/dynamics/rank_share.hpp"

namespace contactsim {

namespace {

/// Entities that follow each other, which one rank knows.
struct KnownStretch {
  std::size_t begin = 0, end = 0;
  int rank = 0;
};

/// The stretches of a range of nodes, or of elements of a block of the model.
std::vector<KnownStretch> find_stretches(bool is_nodal, const OutputContext& context,
                                         const EntityRange& range) {
  const RankShare& share = *context.share;
  std::vector<KnownStretch> stretches;
  const auto add = [&](std::size_t begin, std::size_t end, int rank) {
    begin = std::max(begin, range.first);
    end = std::min(end, range.first + range.count);
    if (begin < end) stretches.push_back({begin, end, rank});
  };
  if (is_nodal) {
    for (std::size_t begin = range.first / nodes_per_sum * nodes_per_sum; begin < range.first + range.count;
         begin += nodes_per_sum)
      add(begin, begin + nodes_per_sum, share.rank_of(NodeIndex{static_cast<std::uint32_t>(begin)}));
    return stretches;
  }
  for (int rank = 0; rank < share.ranks().count(); ++rank) {
    const ModelBlock& block = context.model.blocks[range.block];
    const ChunkRange own = share.chunks_of(rank, range.block);
    if (own.size() == 0) continue;
    const BatchChunk &first = block.chunks[own.begin], &last = block.chunks[own.end - 1];
    add(first.first_batch * n_lanes, (last.first_batch + last.n_batches) * n_lanes, rank);
  }
  return stretches;
}

}  // namespace

void fill_from_ranks(const VariableSelection& selection, const OutputContext& context,
                     const EntityRange& range, std::span<double> values) {
  const FieldLocation location = selection.variable->location;
  if (location == FieldLocation::global) return fill(selection, context, range, values);
  const std::vector<KnownStretch> stretches = find_stretches(location == FieldLocation::node, context, range);
  Ranks& ranks = context.share->ranks();
  const std::size_t n_components = selection.n_components();
  std::vector<double> by_rank(values.size());
  std::vector<std::size_t> begins{0};
  // Calls use(stretch, its values among those by rank) for the stretches of a rank.
  const auto visit = [&](int rank, const auto& use) {
    std::size_t next = begins[static_cast<std::size_t>(rank)];
    for (const KnownStretch& stretch : stretches) {
      if (stretch.rank != rank) continue;
      const std::size_t n = (stretch.end - stretch.begin) * n_components;
      use(stretch, std::span(by_rank).subspan(next, n));
      next += n;
    }
    return next;
  };
  for (int rank = 0; rank < ranks.count(); ++rank) {
    begins.push_back(visit(rank, [&](const KnownStretch& stretch, std::span<double> own) {
      if (rank != ranks.rank()) return;
      fill(selection, context, {range.block, stretch.begin, stretch.end - stretch.begin, range.point}, own);
    }));
  }
  ranks.gather_items(std::span(by_rank), begins);
  for (int rank = 0; rank < ranks.count(); ++rank) {
    visit(rank, [&](const KnownStretch& stretch, std::span<const double> known) {
      std::ranges::copy(
          known, values.begin() + static_cast<std::ptrdiff_t>((stretch.begin - range.first) * n_components));
    });
  }
}

}  // namespace contactsim
