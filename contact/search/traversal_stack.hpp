// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "contact/search/box_tree.hpp"

namespace contactsim {

/// A node of the tree of rows and one of the tree of partners, to be looked at together. In a tree that meets
/// itself a node with itself stands for all pairs below it.
struct BvhNodePair {
  std::uint32_t row, partner;
};

/// What is looked at in place of a node: its two children, or itself alone.
struct OpenedNode {
  std::uint32_t first, has_second;
};

/// Opens a node unless it is a leaf or stays closed; without a branch.
inline OpenedNode open_node(const BoxNode& node, std::uint32_t index, bool stays_closed) {
  const std::uint32_t opens = !node.is_leaf() & !stays_closed, mask = 0u - opens;
  return {(node.link & mask) | (index & ~mask), opens};
}

/// Pairs of nodes that wait to be looked at, the last ones first. They are taken in batches: what comes of
/// one pair does not depend on the others, so that the processor can work on several at a time.
class TraversalStack {
 public:
  using Batch = std::array<BvhNodePair, 128>;

  bool empty() const { return size_ == 0; }
  void push(BvhNodePair pair) {
    reserve(1);
    pairs_[size_++] = pair;
  }
  /// Takes off the last pairs, no more than a batch, and returns how many.
  std::size_t pop(Batch& batch) {
    const std::size_t n = std::min(size_, batch.size());
    size_ -= n;
    std::copy_n(pairs_.data() + size_, n, batch.data());
    return n;
  }
  /// Where to write the children of a batch, four a pair and one more; to be followed by end_at.
  BvhNodePair* room_for_children() {
    reserve(4 * std::tuple_size_v<Batch> + 1);
    return pairs_.data() + size_;
  }
  void end_at(const BvhNodePair* end) { size_ = static_cast<std::size_t>(end - pairs_.data()); }

 private:
  void reserve(std::size_t n) {
    if (size_ + n > pairs_.size()) pairs_.resize(2 * (size_ + n));
  }

  std::vector<BvhNodePair> pairs_;
  std::size_t size_ = 0;
};

}  // namespace contactsim
