// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "contact/mesh/pair_lists.hpp"
#include "contact/search/box_tree.hpp"
#include "contact/search/search_share.hpp"
#include "contact/search/traversal_stack.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// The descent of two trees together, both sides at a time; `is_self` when both are the same one, whose pairs
/// then come once each, the box of the smaller number first.
template <bool is_self>
class BvhPairs {
 public:
  BvhPairs(const BoxTree& rows, const BoxTree& partners)
      : rows_(rows.nodes.data()), partners_(partners.nodes.data()) {}

  /// Some 256 pairs of nodes, below which lie all pairs of boxes that overlap, for threads to share out.
  /// Precondition: neither tree is empty.
  std::vector<BvhNodePair> cut() const {
    constexpr std::size_t n_wanted = 256;
    std::vector<BvhNodePair> pairs, next;
    if (is_self || do_overlap(rows_[0], partners_[0])) pairs.push_back({0, 0});
    bool can_open = true;
    while (can_open && pairs.size() < n_wanted) {
      can_open = false;
      next.clear();
      for (const BvhNodePair pair : pairs) {
        can_open |= !is_last(pair);
        open_to(pair, next);
      }
      pairs.swap(next);
    }
    return pairs;
  }

  /// Adds the pairs of boxes below a pair of nodes for which keep(row, partner) holds.
  template <class Keep>
  void find_below(BvhNodePair top, const Keep& keep, FoundPairs& found) const {
    TraversalStack stack;
    Batch batch, last;
    if (is_self_pair(top)) {
      push_siblings(top.row, stack);
    } else {
      stack.push(top);
    }
    while (!stack.empty()) {
      const std::size_t n = stack.pop(batch);
      found.visits += n;
      BvhNodePair *waiting = stack.room_for_children(), *end = last.data();
      for (std::size_t i = 0; i < n; ++i) step(batch[i], waiting, end);
      stack.end_at(waiting);
      found.overlaps += static_cast<std::uint64_t>(end - last.data());
      for (const BvhNodePair* pair = last.data(); pair != end; ++pair) add(*pair, keep, found);
    }
  }

 private:
  using Batch = TraversalStack::Batch;

  bool is_last(BvhNodePair pair) const {
    return rows_[pair.row].is_leaf() && partners_[pair.partner].is_leaf();
  }
  static bool is_self_pair(BvhNodePair pair) { return is_self && pair.row == pair.partner; }

  /// Sends a pair of leaves to `last`, and the overlapping pairs one step down from any other to `waiting`:
  /// below both nodes, or below the larger one when it is much larger. Without branches: which way they go is
  /// chance.
  void step(BvhNodePair pair, BvhNodePair*& waiting, BvhNodePair*& last) const {
    constexpr std::uint32_t much = 8;
    const BoxNode &row = rows_[pair.row], &partner = partners_[pair.partner];
    const auto [row_1, has_row_2] = open_node(row, pair.row, row.n_boxes < partner.n_boxes / much);
    const auto [partner_1, has_partner_2] =
        open_node(partner, pair.partner, partner.n_boxes < row.n_boxes / much);
    const std::uint32_t row_2 = row_1 + has_row_2, partner_2 = partner_1 + has_partner_2;
    const std::uint32_t opens = has_row_2 | has_partner_2;
    *last = pair;
    last += 1 - opens;
    put_if(opens, {row_1, partner_1}, waiting);
    put_if(has_partner_2, {row_1, partner_2}, waiting);
    put_if(has_row_2, {row_2, partner_1}, waiting);
    put_if(has_row_2 & has_partner_2, {row_2, partner_2}, waiting);
  }

  /// Writes a pair at `to`, to stay there if `is_one` is 1 and its nodes overlap.
  void put_if(std::uint32_t is_one, BvhNodePair pair, BvhNodePair*& to) const {
    *to = pair;
    to += is_one & static_cast<std::uint32_t>(do_overlap(rows_[pair.row], partners_[pair.partner]));
  }

  /// Adds to a list what is one step down from a pair, or a last pair itself.
  void open_to(BvhNodePair pair, std::vector<BvhNodePair>& list) const {
    if (is_last(pair)) {
      list.push_back(pair);
    } else if (is_self_pair(pair)) {
      const std::uint32_t child = rows_[pair.row].link;
      list.insert(list.end(), {{child, child}, {child + 1, child + 1}});
      if (do_overlap(rows_[child], rows_[child + 1])) list.push_back({child, child + 1});
    } else {
      std::array<BvhNodePair, 5> below, last;
      BvhNodePair *end_below = below.data(), *end_last = last.data();
      step(pair, end_below, end_last);
      list.insert(list.end(), below.data(), end_below);
    }
  }

  /// Pushes the overlapping pairs of children of a node and of all nodes below it.
  void push_siblings(std::uint32_t top, TraversalStack& stack) const {
    const std::uint32_t first = rows_[top].link, n_below = 2 * rows_[top].n_boxes - 2;
    const auto push = [&](const BoxNode& parent) {
      if (!parent.is_leaf() && do_overlap(rows_[parent.link], rows_[parent.link + 1]))
        stack.push({parent.link, parent.link + 1});
    };
    push(rows_[top]);
    for (std::uint32_t i = 0; i < n_below; ++i) push(rows_[first + i]);
  }

  template <class Keep>
  void add(BvhNodePair pair, const Keep& keep, FoundPairs& found) const {
    std::uint32_t row = rows_[pair.row].link, partner = partners_[pair.partner].link;
    if (is_self && row > partner) std::swap(row, partner);
    if (keep(row, partner)) found.pairs.push_back({row, partner});
  }

  const BoxNode* rows_;
  const BoxNode* partners_;
};

/// All pairs of boxes of two trees that overlap and that keep(row, partner) holds for, in parts. Which pairs
/// these are, and how many were looked at, does not depend on the number of threads and ranks.
///   keep   called from several threads at once
///   ranks  which search together
template <bool is_self, class Keep>
std::vector<FoundPairs> find_bvh_pairs(const BoxTree& rows, const BoxTree& partners, const Keep& keep,
                                       Ranks& ranks = one_rank()) {
  std::vector<FoundPairs> parts;
  if (rows.nodes.empty() || partners.nodes.empty()) return parts;
  const BvhPairs<is_self> walk(rows, partners);
  const std::vector<BvhNodePair> tops = walk.cut();
  const SearchShare share(ranks, rows.n_boxes());
  parts.resize(tops.size());
  parallel_for_uneven(tops.size(), threads_for(rows.nodes.size()), [&](std::size_t i) {
    if (share.has(i)) walk.find_below(tops[i], keep, parts[i]);
  });
  return share.gather(std::move(parts));
}

}  // namespace contactsim
