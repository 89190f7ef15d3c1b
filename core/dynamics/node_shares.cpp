// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/node_shares.hpp"

#include <algorithm>

namespace contactsim {

NodeShares::NodeShares(const Model& model, const ChunkShares& chunks, std::span<const NodeIndex> everywhere)
    : n_nodes_(static_cast<std::int64_t>(model.mesh->n_nodes())),
      followed_by_((model.mesh->n_nodes() + granule - 1) / granule, 0) {
  const int n_ranks = chunks.n_ranks();
  for (int rank = 0; rank < n_ranks; ++rank) {
    const std::uint64_t bit = std::uint64_t{1} << rank;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      const ModelBlock& block = model.blocks[b];
      const ChunkRange own = chunks.of(rank, b);
      for (std::size_t c = own.begin; c < own.end; ++c) {
        for (const std::uint32_t node : block.nodes_of(block.chunks[c])) followed_by_[node / granule] |= bit;
      }
    }
  }
  // The rank whose elements have most of the nodes of a sum makes it.
  std::vector<std::size_t> n_followed(static_cast<std::size_t>(n_ranks));
  for (std::size_t begin = 0; begin < followed_by_.size(); begin += granules_per_sum) {
    const std::size_t end = std::min(begin + granules_per_sum, followed_by_.size());
    std::ranges::fill(n_followed, 0);
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t r = 0; r < n_followed.size(); ++r) n_followed[r] += followed_by_[i] >> r & 1U;
    }
    rank_of_sum_.push_back(static_cast<int>(std::ranges::max_element(n_followed) - n_followed.begin()));
  }
  for (std::size_t i = 0; i < followed_by_.size(); ++i)
    followed_by_[i] |= std::uint64_t{1} << rank_of_sum_[i / granules_per_sum];
  const auto follow_everywhere = [&](std::span<const NodeIndex> nodes) {
    for (const NodeIndex node : nodes) followed_by_[node.value / granule] = ~std::uint64_t{0};
  };
  follow_everywhere(everywhere);
  follow_everywhere(model.kinematic_constraints.nodes());
  follow_everywhere(model.rotation_constraints.nodes());
  for (const RigidBody& body : model.rigid.bodies) follow_everywhere(body.nodes);
}

/// What a rank follows where counts(granule) holds.
template <class Counts>
std::vector<NodeRange> NodeShares::find_ranges(int rank, const Counts& counts) const {
  std::vector<NodeRange> ranges;
  for (std::size_t i = 0; i < followed_by_.size(); ++i) {
    if ((followed_by_[i] >> rank & 1U) == 0 || !counts(i)) continue;
    const auto begin = static_cast<std::int64_t>(i * granule);
    const std::int64_t end = std::min<std::int64_t>(begin + granule, n_nodes_);
    if (!ranges.empty() && ranges.back().end == begin) {
      ranges.back().end = end;
    } else {
      ranges.push_back({begin, end});
    }
  }
  return ranges;
}

std::vector<NodeRange> NodeShares::followed(int rank) const {
  return find_ranges(rank, [](std::size_t) { return true; });
}

std::vector<NodeRange> NodeShares::followed_for_others(int rank) const {
  return find_ranges(rank, [&](std::size_t i) { return rank_of_sum_[i / granules_per_sum] != rank; });
}

NodeRange NodeShares::nodes_of_sum(std::size_t i) const {
  const auto begin = static_cast<std::int64_t>(i * nodes_per_sum);
  return {begin, std::min<std::int64_t>(begin + nodes_per_sum, n_nodes_)};
}

}  // namespace contactsim
