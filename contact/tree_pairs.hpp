// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "contact/box_tree.hpp"
#include "contact/pair_lists.hpp"
#include "core/threads.hpp"

namespace contactsim {

/// A node of the tree of rows and one of the tree of partners, to be looked at together. In a tree that meets
/// itself a node with itself stands for all pairs below it.
struct NodePair {
  std::uint32_t row, partner;
};

/// The descent of two trees together; `is_self` when both are the same one, whose pairs then come once each,
/// the box of the smaller number first.
template <bool is_self>
class TreePairs {
 public:
  TreePairs(const BoxTree& rows, const BoxTree& partners)
      : rows_(rows.nodes.data()),
        partners_(partners.nodes.data()),
        n_open_(2 * (rows.depth + partners.depth)) {}

  /// Some 256 pairs of nodes, below which lie all pairs of boxes that overlap, for threads to share out.
  /// Precondition: neither tree is empty.
  std::vector<NodePair> cut() const {
    constexpr std::size_t n_wanted = 256;
    std::vector<NodePair> pairs, next;
    if (is_self || do_overlap(rows_[0], partners_[0])) pairs.push_back({0, 0});
    bool can_open = true;
    while (can_open && pairs.size() < n_wanted) {
      can_open = false;
      next.clear();
      for (const NodePair pair : pairs) {
        if (is_last(pair)) {
          next.push_back(pair);
        } else {
          can_open = true;
          open(pair, [&](NodePair below) { next.push_back(below); });
        }
      }
      pairs.swap(next);
    }
    return pairs;
  }

  /// Adds the pairs of boxes below a pair of nodes for which keep(row, partner) holds.
  template <class Keep>
  void find_below(NodePair top, const Keep& keep, FoundPairs& found) const {
    std::vector<NodePair> stack(n_open_ + 1);
    NodePair* open_pairs = stack.data();
    std::uint64_t visits = 0;
    *open_pairs++ = top;
    while (open_pairs != stack.data()) {
      const NodePair pair = *--open_pairs;
      ++visits;
      if (is_last(pair)) {
        add(pair, keep, found);
      } else {
        open(pair, [&](NodePair below) { *open_pairs++ = below; });
      }
    }
    found.visits += visits;
  }

 private:
  bool is_last(NodePair pair) const { return rows_[pair.row].is_leaf() && partners_[pair.partner].is_leaf(); }

  /// Calls push for the overlapping pairs one step down from a pair that is not the last.
  template <class Push>
  void open(NodePair pair, const Push& push) const {
    const BoxNode &row = rows_[pair.row], &partner = partners_[pair.partner];
    if (is_self && pair.row == pair.partner) {
      push({row.link, row.link});
      push({row.link + 1, row.link + 1});
      if (do_overlap(rows_[row.link], rows_[row.link + 1])) push({row.link, row.link + 1});
    } else if (row.n_boxes >= partner.n_boxes) {
      if (do_overlap(rows_[row.link], partner)) push({row.link, pair.partner});
      if (do_overlap(rows_[row.link + 1], partner)) push({row.link + 1, pair.partner});
    } else {
      if (do_overlap(row, partners_[partner.link])) push({pair.row, partner.link});
      if (do_overlap(row, partners_[partner.link + 1])) push({pair.row, partner.link + 1});
    }
  }

  template <class Keep>
  void add(NodePair pair, const Keep& keep, FoundPairs& found) const {
    if (is_self && pair.row == pair.partner) return;
    std::uint32_t row = rows_[pair.row].link, partner = partners_[pair.partner].link;
    if (is_self && row > partner) std::swap(row, partner);
    if (keep(row, partner)) found.pairs.push_back({row, partner});
  }

  const BoxNode* rows_;
  const BoxNode* partners_;
  std::size_t n_open_;  ///< at most that many pairs of nodes wait at a time
};

/// All pairs of boxes of two trees that overlap and that keep(row, partner) holds for, in parts whose number
/// and content do not depend on the number of threads.
///   keep   called from several threads at once
///   parts  overwritten, their memory reused
template <bool is_self, class Keep>
void find_tree_pairs(const BoxTree& rows, const BoxTree& partners, const Keep& keep,
                     std::vector<FoundPairs>& parts) {
  for (FoundPairs& part : parts) part.clear();
  if (rows.nodes.empty() || partners.nodes.empty()) return;
  const TreePairs<is_self> walk(rows, partners);
  const std::vector<NodePair> tops = walk.cut();
  if (parts.size() < tops.size()) parts.resize(tops.size());
  const auto n_tops = static_cast<std::int64_t>(tops.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(rows.nodes.size()))
  for (std::int64_t i = 0; i < n_tops; ++i) walk.find_below(tops[i], keep, parts[i]);
}

}  // namespace contactsim
