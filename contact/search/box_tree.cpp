// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/box_tree.hpp"

#include <limits>

namespace contactsim {

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
