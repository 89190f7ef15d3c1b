// SPDX-License-Identifier: BSD-3-Clause
#include "contact/box_tree.hpp"

#include <algorithm>
#include <bit>
#include <limits>

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

}  // namespace

bool is_sound(const Box& box) {
  constexpr double most = std::numeric_limits<double>::max();
  bool sound = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sound &= -most <= box.lo[axis] && box.lo[axis] <= box.hi[axis] && box.hi[axis] <= most;
  return sound;
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

}  // namespace contactsim
