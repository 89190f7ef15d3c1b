// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/node_shares.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace contactsim {

NodeShares::NodeShares(const Model& model, const ChunkShares& chunks, std::span<const NodeIndex> everywhere)
    : followed_by_(model.mesh->n_nodes(), 0) {
  for (int rank = 0; rank < chunks.n_ranks(); ++rank) {
    const std::uint64_t bit = std::uint64_t{1} << rank;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      const ModelBlock& block = model.blocks[b];
      const ChunkRange own = chunks.of(rank, b);
      for (std::size_t c = own.begin; c < own.end; ++c) {
        for (const std::uint32_t node : block.nodes_of(block.chunks[c])) followed_by_[node] |= bit;
      }
    }
  }
  // Nodes without elements move, too: the first rank has them.
  std::ranges::replace(followed_by_, std::uint64_t{0}, std::uint64_t{1});
  // The rank whose elements have most of the nodes of a sum makes it.
  std::array<std::size_t, max_ranks> n_followed;
  for (std::size_t begin = 0; begin < followed_by_.size(); begin += nodes_per_sum) {
    const std::size_t n = std::min<std::size_t>(nodes_per_sum, followed_by_.size() - begin);
    const std::span masks = std::span(followed_by_).subspan(begin, n);
    n_followed.fill(0);
    for (std::uint64_t left : masks) {
      for (; left != 0; left &= left - 1) ++n_followed[static_cast<std::size_t>(std::countr_zero(left))];
    }
    const auto most = std::ranges::max_element(n_followed) - n_followed.begin();
    rank_of_sum_.push_back(static_cast<int>(most));
    for (std::uint64_t& mask : masks) mask |= std::uint64_t{1} << most;
  }
  const auto follow_everywhere = [&](std::span<const NodeIndex> nodes) {
    for (const NodeIndex node : nodes) followed_by_[node.value] = ~std::uint64_t{0};
  };
  follow_everywhere(everywhere);
  follow_everywhere(model.kinematic_constraints.nodes());
  follow_everywhere(model.rotation_constraints.nodes());
  for (const RigidBody& body : model.rigid.bodies) follow_everywhere(body.nodes);
}

/// The nodes for which counts(node) holds.
template <class Counts>
std::vector<NodeRange> NodeShares::find_ranges(const Counts& counts) const {
  std::vector<NodeRange> ranges;
  for (std::uint32_t node = 0; node < followed_by_.size(); ++node) {
    if (!counts(node)) continue;
    if (ranges.empty() || ranges.back().end != node) ranges.push_back({node, node});
    ranges.back().end = std::int64_t{node} + 1;
  }
  return ranges;
}

std::vector<NodeRange> NodeShares::followed(int rank) const {
  return find_ranges([&](std::uint32_t node) { return follows(rank, node); });
}

std::vector<NodeRange> NodeShares::followed_for_others(int rank) const {
  return find_ranges(
      [&](std::uint32_t node) { return follows(rank, node) && rank_of_sum_[node / nodes_per_sum] != rank; });
}

NodeRange NodeShares::nodes_of_sum(std::size_t i) const {
  const auto begin = static_cast<std::int64_t>(i * nodes_per_sum);
  return {begin,
          std::min<std::int64_t>(begin + nodes_per_sum, static_cast<std::int64_t>(followed_by_.size()))};
}

}  // namespace contactsim
