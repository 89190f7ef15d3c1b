// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/dynamics/chunk_shares.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/node_shares.hpp"
#include "core/dynamics/rank_traffic.hpp"
#include "core/elements/element_table.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

/// What a rank does of a step of explicit dynamics, or of a trial of a load step, and what it tells the
/// others. It advances its own chunks of elements; the sums that the others' chunks have at the nodes that it
/// follows arrive in the very places where its own would stand, so that NodeSums adds up at each node in the
/// order of one process: the same bits for any number of ranks. All ranks call its functions alike.
class RankShare {
 public:
  /// Ranks and model must outlive it.
  ///   everywhere  nodes that all ranks have to follow
  RankShare(Ranks& ranks, const Model& model, std::span<const NodeIndex> everywhere);
  RankShare(const RankShare&) = delete;
  RankShare& operator=(const RankShare&) = delete;

  Ranks& ranks() const { return ranks_; }
  ChunkRange chunks_of(int rank, std::size_t block) const { return chunks_.of(rank, block); }
  ChunkRange own_chunks(std::size_t block) const { return chunks_of(ranks_.rank(), block); }
  /// Where what they remember stands in ModelBlockState::values.
  ChunkRange own_values(std::size_t block) const;
  /// The rank that advances an element of the mesh, none of one that is not advanced.
  std::optional<int> rank_of(ElementIndex element) const;
  bool has_element(ElementIndex element) const { return rank_of(element) == ranks_.rank(); }
  /// A rank that follows a node.
  int rank_of(NodeIndex node) const { return nodes_.rank_of_sum(node.value / nodes_per_sum); }
  /// Ranks::join().
  template <class Item>
  std::vector<Item> join(const std::vector<Item>& own) const {
    return ranks_.join(own);
  }
  const NodeRanges& followed() const { return followed_; }
  /// Those of them whose sums other ranks make.
  const NodeRanges& others_followed() const { return others_followed_; }
  /// What a step sends.
  RankTraffic traffic() const { return find_traffic(model_, chunks_, nodes_); }
  bool makes_sum(std::size_t i) const { return nodes_.rank_of_sum(i) == ranks_.rank(); }

  /// Completes what a step has made of the chunks: forces and moments at the nodes that are followed, and
  ///   steps  [n_chunks of all blocks] those of the own chunks are known
  void exchange(std::span<ChunkStep> steps, State& state);

  /// Completes what each rank has of its own chunks.
  ///   of_chunks  [n_chunks of all blocks] items without pointers
  template <class Item>
  void complete_chunks(std::span<Item> of_chunks) const {
    ranks_.gather_items(of_chunks, chunks_.begins());
  }
  /// Completes sums over nodes.
  ///   sums  [n_sums] those that this rank makes are known
  template <class Sum>
  void complete_sums(std::vector<Sum>& sums);

  /// Completes the state between two steps for who reads more of it: all nodes, and what elements remember.
  void complete(State& state);
  /// The nodes alone.
  void complete_nodes(State& state);
  /// What elements remember alone.
  void complete_elements(State& state);
  /// Brings all ranks the values of all nodes, each from the rank that makes the sums of it.
  ///   values  [3 x n_nodes], or without columns
  void gather_nodes(Eigen::Matrix3Xd& values);

 private:
  /// The places of a block's chunk sums that go from one rank to another.
  using Places = std::vector<std::vector<std::uint32_t>>;  // [n_blocks]

  void find_places();
  std::size_t message_size(const Places& places) const;
  template <class Item>
  void visit(const Places& places, State& state, const Item& item) const;

  Ranks& ranks_;
  const Model& model_;
  ChunkShares chunks_;
  NodeShares nodes_;
  NodeRanges followed_, others_followed_;
  std::vector<Places> out_, in_;                    // [n_ranks] to and from
  std::vector<std::vector<std::byte>> sent_, got_;  // [n_ranks] messages
  std::vector<std::uint32_t> sums_by_rank_;         // [n_sums] those of the first rank first
  std::vector<std::size_t> first_sum_;              // [n_ranks + 1] in sums_by_rank_
  std::vector<double> at_nodes_;                    // [3 x n_nodes] by ranks, what is gathered
};

template <class Sum>
void RankShare::complete_sums(std::vector<Sum>& sums) {
  std::vector<Sum> sorted;
  sorted.reserve(sums.size());
  for (const std::uint32_t i : sums_by_rank_) sorted.push_back(sums[i]);
  ranks_.gather_items(std::span(sorted), first_sum_);
  for (std::size_t k = 0; k < sorted.size(); ++k) sums[sums_by_rank_[k]] = sorted[k];
}

}  // namespace contactsim
