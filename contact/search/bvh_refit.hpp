// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>

#include "contact/search/box_tree.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// +1 where adding one to the bits leads away from zero upward, -1 below zero.
inline std::int32_t upward(std::int32_t bits) { return (bits >> 31) | 1; }

/// The greatest float that is not above x. Rounding keeps the sign of a zero, so one step on the bits is
/// enough.
inline float round_down(double x) {
  const float nearest = static_cast<float>(x);
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits - (nearest > x) * upward(bits));
}

/// The least float that is not below x.
inline float round_up(double x) {
  const float nearest = static_cast<float>(x);
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits + (nearest < x) * upward(bits));
}

/// Fits a leaf to its box, rounded outward.
inline void fit_leaf(BoxNode& leaf, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    leaf.lo[axis] = round_down(box.lo[axis]);
    leaf.hi[axis] = round_up(box.hi[axis]);
  }
}

/// Fits a node to its two children.
inline void fit_parent(BoxNode& parent, const BoxNode* children) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    parent.lo[axis] = std::min(children[0].lo[axis], children[1].lo[axis]);
    parent.hi[axis] = std::max(children[0].hi[axis], children[1].hi[axis]);
  }
}

/// Fits a tree to boxes that have moved; who is whose child stays. Boxes are asked for one by one and not
/// kept: at the size of a large surface that saves their memory and one way through it.
template <class BoxOf>
class BvhRefit {
 public:
  /// box_of(i)  box i as it is now; called from several threads at once
  BvhRefit(BoxTree& tree, const BoxOf& box_of) : nodes_(tree.nodes.data()), box_of_(box_of) {}

  /// Fits all that is below a node, last first, then the node. Returns the smallest number of a box that is
  /// not sound, `all_sound` if all are.
  std::uint32_t fit_branch(std::uint32_t root) const {
    const std::uint32_t n_below = 2 * nodes_[root].n_boxes - 2, first = nodes_[root].link;
    std::uint32_t unsound = all_sound;
    for (std::uint32_t i = n_below; i-- > 0;) unsound = std::min(unsound, fit(nodes_[first + i]));
    return std::min(unsound, fit(nodes_[root]));
  }
  std::uint32_t fit(BoxNode& node) const {
    if (!node.is_leaf()) {
      fit_parent(node, &nodes_[node.link]);
      return all_sound;
    }
    const Box box = box_of_(node.link);
    fit_leaf(node, box);
    return is_sound(box) ? all_sound : node.link;
  }

  /// Greater than any number of a box, as a minimum begins.
  static constexpr std::uint32_t all_sound = std::numeric_limits<std::uint32_t>::max();

 private:
  BoxNode* nodes_;
  const BoxOf& box_of_;
};

/// Fits the nodes of a tree to boxes that have moved, on OpenMP's threads. Returns the number of the first
/// box that is not sound, after which the tree means nothing until it is fitted again.
template <class BoxOf>
std::optional<std::uint32_t> refit(BoxTree& tree, const BoxOf& box_of) {
  const BvhRefit fit(tree, box_of);
  std::uint32_t unsound = fit.all_sound;
  const auto n_branches = static_cast<std::int64_t>(tree.branches.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(tree.nodes.size())) reduction(min \
                                                                                                 : unsound)
  for (std::int64_t i = 0; i < n_branches; ++i)
    unsound = std::min(unsound, fit.fit_branch(tree.branches[static_cast<std::size_t>(i)]));
  for (std::size_t i = tree.top_levels.size(); i-- > 0;) fit.fit(tree.nodes[tree.top_levels[i]]);
  return unsound == fit.all_sound ? std::nullopt : std::optional(unsound);
}

}  // namespace contactsim
