// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/indices.hpp"
#include "core/base/node_ranges.hpp"
#include "core/dynamics/chunk_shares.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

/// Nodes whose energies and momenta are summed together, in the order of the mesh: such sums do not depend on
/// who makes them.
inline constexpr std::uint32_t nodes_per_sum = 2048;

/// Which nodes the ranks follow through a step: where they are, how they move, what pushes them. A rank
/// follows the nodes of its own elements, those whose sums it makes, and those that all must know: of
/// contact, of loaded faces, held, driven or rigid ones. Of other nodes it has what was gathered last.
class NodeShares {
 public:
  ///   everywhere  nodes that all ranks follow, besides those that are held, driven or rigid
  NodeShares(const Model& model, const ChunkShares& chunks, std::span<const NodeIndex> everywhere);

  bool follows(int rank, std::uint32_t node) const { return (followers(node) >> rank & 1U) != 0; }
  /// The ranks that follow a node, a bit of each; of nodes that all follow the bits beyond too.
  std::uint64_t followers(std::uint32_t node) const { return followed_by_[node]; }
  /// All nodes that a rank follows.
  std::vector<NodeRange> followed(int rank) const;
  /// Those whose sums other ranks make.
  std::vector<NodeRange> followed_for_others(int rank) const;
  std::size_t n_sums() const { return rank_of_sum_.size(); }
  /// The rank that makes the sums of some nodes: from nodes_per_sum x i on.
  int rank_of_sum(std::size_t i) const { return rank_of_sum_[i]; }
  /// The nodes of such a sum.
  NodeRange nodes_of_sum(std::size_t i) const;

  /// Masks have so many bits.
  static constexpr int max_ranks = 64;

 private:
  template <class Counts>
  std::vector<NodeRange> find_ranges(const Counts& counts) const;

  std::vector<std::uint64_t> followed_by_;  // [n_nodes] a bit of each rank
  std::vector<int> rank_of_sum_;
};

}  // namespace contactsim
