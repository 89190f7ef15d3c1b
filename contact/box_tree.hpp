// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace contactsim {

/// A box along the axes, walls included [length].
struct Box {
  std::array<double, 3> lo, hi;
};

/// Whether two boxes share a point; boxes that only touch do.
inline bool do_overlap(const Box& a, const Box& b) {
  return a.lo[0] <= b.hi[0] && b.lo[0] <= a.hi[0] && a.lo[1] <= b.hi[1] && b.lo[1] <= a.hi[1] &&
         a.lo[2] <= b.hi[2] && b.lo[2] <= a.hi[2];
}

/// Whether lo <= hi on every axis and all six numbers are finite.
bool is_sound(const Box& box);

/// A node of a BoxTree: its box, rounded outward, and where to go on. Half a cache line.
struct BoxNode {
  std::array<float, 3> lo;
  std::uint32_t n_boxes;  ///< boxes below, 1 in a leaf
  std::array<float, 3> hi;
  std::uint32_t link;  ///< in a leaf the number of its box, else its first child; the other one comes next

  bool is_leaf() const { return n_boxes == 1; }
};
static_assert(sizeof(BoxNode) == 32);

/// Whether the boxes of two nodes share a point. Never false when boxes below them do.
inline bool do_overlap(const BoxNode& a, const BoxNode& b) {
  const bool x = (a.lo[0] <= b.hi[0]) & (b.lo[0] <= a.hi[0]);
  const bool y = (a.lo[1] <= b.hi[1]) & (b.lo[1] <= a.hi[1]);
  const bool z = (a.lo[2] <= b.hi[2]) & (b.lo[2] <= a.hi[2]);
  return x & y & z;
}

/// A binary tree over n boxes, flat in memory. Children stand after their parents, and all that is below a
/// node stands together, from its first child on: 2 * n_boxes - 2 nodes.
struct BoxTree {
  std::vector<BoxNode> nodes;           ///< [2 n - 1], the root first; empty without boxes
  std::vector<std::uint32_t> branches;  ///< nodes whose subtrees are disjoint and hold all boxes
  std::vector<std::uint32_t> crown;     ///< the nodes above the branches, parents first
  std::uint32_t depth = 0;              ///< nodes on the longest way down

  /// How many boxes it is over.
  std::uint32_t n_boxes() const { return nodes.empty() ? 0 : nodes.front().n_boxes; }
};

/// Fills in branches, crown and depth of a tree whose nodes are linked.
void divide(BoxTree& tree);

/// Fits the nodes to boxes that have moved; who is whose child stays. Runs on OpenMP's threads.
///   boxes  [n_boxes of the tree] sound
void refit(BoxTree& tree, std::span<const Box> boxes);

}  // namespace contactsim
