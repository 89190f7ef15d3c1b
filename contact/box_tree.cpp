// SPDX-License-Identifier: BSD-3-Clause
#include "contact/box_tree.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "core/threads.hpp"

namespace contactsim {

namespace {

/// +1 where adding one to the bits leads away from zero upward, -1 below zero.
std::int32_t upward(std::int32_t bits) { return (bits >> 31) | 1; }

/// The greatest float that is not above x. Rounding keeps the sign of a zero, so one step on the bits is
/// enough.
float round_down(double x) {
  const float nearest = static_cast<float>(x);
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits - (nearest > x) * upward(bits));
}

/// The least float that is not below x.
float round_up(double x) {
  const float nearest = static_cast<float>(x);
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits + (nearest < x) * upward(bits));
}

void fit_leaf(BoxNode& leaf, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    leaf.lo[axis] = round_down(box.lo[axis]);
    leaf.hi[axis] = round_up(box.hi[axis]);
  }
}

void fit_parent(BoxNode& parent, const BoxNode* children) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    parent.lo[axis] = std::min(children[0].lo[axis], children[1].lo[axis]);
    parent.hi[axis] = std::max(children[0].hi[axis], children[1].hi[axis]);
  }
}

void fit_node(BoxTree& tree, std::uint32_t index, std::span<const Box> boxes) {
  BoxNode& node = tree.nodes[index];
  if (node.is_leaf()) {
    fit_leaf(node, boxes[node.link]);
  } else {
    fit_parent(node, &tree.nodes[node.link]);
  }
}

/// Fits all that is below a node, last first, then the node.
void fit_branch(BoxTree& tree, std::uint32_t root, std::span<const Box> boxes) {
  const std::uint32_t n_below = 2 * tree.nodes[root].n_boxes - 2, first = tree.nodes[root].link;
  for (std::uint32_t i = n_below; i-- > 0;) fit_node(tree, first + i, boxes);
  fit_node(tree, root, boxes);
}

}  // namespace

bool is_sound(const Box& box) {
  constexpr double most = std::numeric_limits<double>::max();
  bool sound = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sound &= -most <= box.lo[axis] && box.lo[axis] <= box.hi[axis] && box.hi[axis] <= most;
  return sound;
}

void divide(BoxTree& tree) {
  constexpr std::uint32_t n_parts = 64;
  tree.branches.clear();
  tree.crown.clear();
  const std::uint32_t branch_size = tree.n_boxes() / n_parts + 1;
  std::vector<std::uint32_t> open(tree.nodes.empty() ? 0 : 1, 0u);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    const BoxNode& node = tree.nodes[i];
    if (node.n_boxes <= branch_size) {
      tree.branches.push_back(i);
    } else {
      tree.crown.push_back(i);
      open.insert(open.end(), {node.link + 1, node.link});
    }
  }
}

void refit(BoxTree& tree, std::span<const Box> boxes) {
  assert(boxes.size() == tree.n_boxes());
  const auto n_branches = static_cast<std::int64_t>(tree.branches.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(tree.nodes.size()))
  for (std::int64_t i = 0; i < n_branches; ++i) fit_branch(tree, tree.branches[i], boxes);
  for (std::size_t i = tree.crown.size(); i-- > 0;) fit_node(tree, tree.crown[i], boxes);
}

}  // namespace contactsim
