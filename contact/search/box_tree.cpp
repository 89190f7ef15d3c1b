// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/box_tree.hpp"

#include <algorithm>
#include <limits>

#include "contact/search/bvh_refit.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

bool is_sound(const Box& box) {
  constexpr double most = std::numeric_limits<double>::max();
  bool sound = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sound &= -most <= box.lo[axis] && box.lo[axis] <= box.hi[axis] && box.hi[axis] <= most;
  return sound;
}

namespace {

/// The middle of a box; in single precision, which is enough to halve boxes by.
struct BoxCentre {
  std::array<float, 3> x;
  std::uint32_t box;
};

/// Boxes that stand together, where their node is and where those below it begin.
struct TreePart {
  std::span<BoxCentre> boxes;
  std::size_t node, below;
};

/// Across the longest side of the box around the centres.
std::size_t find_axis(std::span<const BoxCentre> boxes) {
  std::array<float, 3> lo = boxes.front().x, hi = lo;
  for (const BoxCentre& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lo[axis] = std::min(lo[axis], box.x[axis]);
      hi[axis] = std::max(hi[axis], box.x[axis]);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (hi[axis] - lo[axis] > hi[longest] - lo[longest]) longest = axis;
  }
  return longest;
}

/// Makes the node of a part with at least two boxes, and halves it.
std::array<TreePart, 2> halve(const TreePart& part, BoxTree& tree) {
  const std::size_t axis = find_axis(part.boxes), n_first = part.boxes.size() / 2;
  const auto middle = part.boxes.begin() + static_cast<std::ptrdiff_t>(n_first);
  std::nth_element(part.boxes.begin(), middle, part.boxes.end(),
                   [axis](const BoxCentre& a, const BoxCentre& b) { return a.x[axis] < b.x[axis]; });
  tree.nodes[part.node].n_boxes = static_cast<std::uint32_t>(part.boxes.size());
  tree.nodes[part.node].link = static_cast<std::uint32_t>(part.below);
  const std::size_t below_first = part.below + 2;
  return {TreePart{part.boxes.first(n_first), part.below, below_first},
          TreePart{part.boxes.subspan(n_first), part.below + 1, below_first + 2 * n_first - 2}};
}

/// Makes all nodes of a part.
void make_nodes(const TreePart& part, BoxTree& tree) {
  if (part.boxes.size() == 1) {
    tree.nodes[part.node].n_boxes = 1;
    tree.nodes[part.node].link = part.boxes.front().box;
    return;
  }
  for (const TreePart& half : halve(part, tree)) make_nodes(half, tree);
}

}  // namespace

BoxTree make_box_tree(std::span<const Box> boxes) {
  constexpr std::size_t boxes_per_part = 4096, max_parts = 16;
  BoxTree tree;
  if (boxes.empty()) return tree;
  std::vector<BoxCentre> centres(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      centres[i].x[axis] = static_cast<float>(0.5 * boxes[i].lo[axis] + 0.5 * boxes[i].hi[axis]);
    centres[i].box = i;
  }
  tree.nodes.resize(2 * boxes.size() - 1);
  std::vector<TreePart> parts{{centres, 0, 1}};
  while (parts.size() < max_parts && parts.back().boxes.size() > boxes_per_part) {
    std::vector<TreePart> halves;
    for (const TreePart& part : parts) {
      const auto two = halve(part, tree);
      halves.insert(halves.end(), two.begin(), two.end());
    }
    parts = std::move(halves);
  }
  parallel_for_uneven(parts.size(), threads_for(boxes.size()),
                      [&](std::size_t i) { make_nodes(parts[i], tree); });
  divide(tree);
  refit(tree, [&](std::uint32_t i) { return boxes[i]; });
  return tree;
}

void divide(BoxTree& tree) {
  constexpr std::uint32_t n_parts = 64;
  tree.branches.clear();
  tree.top_levels.clear();
  const std::uint32_t branch_size = tree.n_boxes() / n_parts + 1;
  std::vector<std::uint32_t> open(tree.nodes.empty() ? 0 : 1, 0u);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    const BoxNode& node = tree.nodes[i];
    if (node.n_boxes <= branch_size) {
      tree.branches.push_back(i);
    } else {
      tree.top_levels.push_back(i);
      open.insert(open.end(), {node.link + 1, node.link});
    }
  }
}

}  // namespace contactsim
