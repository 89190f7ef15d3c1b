// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

#include "core/base/bytes_of.hpp"

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

/// A node of a BoxTree: its box, rounded outward, and its children. Half a cache line.
struct BoxNode {
  std::array<float, 3> lo;
  std::uint32_t n_boxes;  ///< boxes below, 1 in a leaf
  std::array<float, 3> hi;
  std::uint32_t link;  ///< in a leaf the number of its box, else its first child; the other one comes next

  bool is_leaf() const { return n_boxes == 1; }
};
static_assert(sizeof(BoxNode) == 32);

/// One side of a node, lo or hi, and in the fourth lane what is no coordinate.
using NodeSide [[gnu::vector_size(16)]] = float;

/// Whether the boxes of two nodes share a point. Never false when boxes below them do.
inline bool do_overlap(const BoxNode& a, const BoxNode& b) {
  const auto side = [](const BoxNode& node, std::size_t first_byte) {
    NodeSide lanes;
    std::memcpy(&lanes, reinterpret_cast<const std::byte*>(&node) + first_byte, sizeof lanes);
    return lanes;
  };
  constexpr std::size_t lo = offsetof(BoxNode, lo), hi = offsetof(BoxNode, hi);
  const auto lanes = (side(a, lo) <= side(b, hi)) & (side(b, lo) <= side(a, hi));
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(lanes);
  constexpr std::uint64_t all = ~std::uint64_t{0}, fourth_lane = all << 32;
  return (halves[0] & (halves[1] | fourth_lane)) == all;
}

/// Memory whose second node begins a cache line, so that the two children of a node share one.
template <class Node>
struct SiblingAllocator {
  using value_type = Node;
  static constexpr std::align_val_t line{64};
  static_assert(2 * sizeof(Node) == 64);

  SiblingAllocator() = default;
  template <class Other>
  SiblingAllocator(const SiblingAllocator<Other>&) {}

  Node* allocate(std::size_t n) {
    return static_cast<Node*>(::operator new((n + 1) * sizeof(Node), line)) + 1;
  }
  void deallocate(Node* first, std::size_t) { ::operator delete(first - 1, line); }
  bool operator==(const SiblingAllocator&) const { return true; }
};

/// A binary tree over n boxes, flat in memory. Children stand after their parents, and all that is below a
/// node stands together, from its first child on: 2 * n_boxes - 2 nodes.
struct BoxTree {
  std::vector<BoxNode, SiblingAllocator<BoxNode>> nodes;  ///< [2 n - 1], the root first; empty without boxes
  std::vector<std::uint32_t> branches;    ///< nodes whose subtrees are disjoint and hold all boxes
  std::vector<std::uint32_t> top_levels;  ///< the nodes above the branches, parents first

  std::size_t bytes() const { return bytes_of(nodes) + bytes_of(branches) + bytes_of(top_levels); }
  /// How many boxes it is over.
  std::uint32_t n_boxes() const { return nodes.empty() ? 0 : nodes.front().n_boxes; }
};

/// Fills in branches and top levels of a tree whose nodes are linked.
void divide(BoxTree& tree);

}  // namespace contactsim
