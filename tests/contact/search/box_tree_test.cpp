// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/search/broad_phase.hpp"
#include "support/catch.hpp"
#include "support/moving_boxes.hpp"

using namespace contactsim;
using test::MovingBoxes;

namespace {

bool holds(const BoxNode& node, const Box& box) {
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    inside = inside && node.lo[axis] <= box.lo[axis] && box.hi[axis] <= node.hi[axis];
  return inside;
}

/// Marks the boxes below a node; false where one lies outside of it or has been marked before.
bool mark_boxes(const BoxTree& tree, const BoxNode& top, const std::vector<Box>& boxes,
                std::vector<bool>& marked) {
  std::vector<BoxNode> open = {top};
  bool fits = true;
  while (!open.empty()) {
    const BoxNode node = open.back();
    open.pop_back();
    if (node.is_leaf()) {
      fits = fits && !marked[node.link] && holds(top, boxes[node.link]);
      marked[node.link] = true;
    } else {
      open.insert(open.end(), {tree.nodes[node.link], tree.nodes[node.link + 1]});
    }
  }
  return fits;
}

}  // namespace

TEST_CASE("trees have children after their parents and all below a node together", "[contact][box_tree]") {
  const std::uint32_t n = GENERATE(1u, 2u, 3u, 1000u, 4097u, 100001u);  // FCL makes large ones in parts
  const BoxTree tree = make_box_tree(MovingBoxes(n, 1).boxes());
  REQUIRE(tree.nodes.size() == 2 * n - 1);
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    const BoxNode& node = tree.nodes[i];
    if (node.is_leaf()) continue;
    REQUIRE(node.link > i);
    const BoxNode &first = tree.nodes[node.link], &second = tree.nodes[node.link + 1];
    CHECK(first.n_boxes + second.n_boxes == node.n_boxes);
    if (!first.is_leaf()) CHECK(first.link == node.link + 2);
    if (!second.is_leaf()) CHECK(second.link == node.link + 2 + 2 * first.n_boxes - 2);
  }
}

TEST_CASE("every node of a tree holds the boxes below it, before and after a refit", "[contact][box_tree]") {
  MovingBoxes moving(500, 2);
  BoxTree tree = make_box_tree(moving.boxes());
  for (int step = 0; step < 3; ++step) {
    for (const BoxNode& node : tree.nodes) {
      std::vector<bool> marked(moving.boxes().size());
      REQUIRE(mark_boxes(tree, node, moving.boxes(), marked));
      REQUIRE(std::count(marked.begin(), marked.end(), true) == node.n_boxes);
    }
    moving.step();
    REQUIRE(!refit(tree, [&](std::uint32_t i) { return moving.boxes()[i]; }));
  }
}

TEST_CASE("branches are disjoint, hold all boxes and lie below the crown", "[contact][box_tree]") {
  const std::uint32_t n = GENERATE(3000u, 30000u);
  const auto boxes = MovingBoxes(n, 3).boxes();
  const BoxTree tree = make_box_tree(boxes);
  std::vector<bool> marked(boxes.size());
  for (const std::uint32_t branch : tree.branches)
    REQUIRE(mark_boxes(tree, tree.nodes[branch], boxes, marked));
  CHECK(std::count(marked.begin(), marked.end(), true) == n);
  CHECK(tree.branches.size() == tree.top_levels.size() + 1);
  CHECK(tree.branches.size() >= 64);
}

TEST_CASE("the two children of a node share a cache line", "[contact][box_tree]") {
  const BoxTree tree = make_box_tree(MovingBoxes(10, 1).boxes());
  for (std::size_t i = 1; i < tree.nodes.size(); i += 2)
    CHECK(reinterpret_cast<std::uintptr_t>(&tree.nodes[i]) % 64 == 0);
}

TEST_CASE("leaves are rounded outward, by one float at most", "[contact][box_tree]") {
  const double x = GENERATE(0.1, -0.1, 1.0, 0.0, -0.0, 1e-60, -1e-60, 1e-42, 1.0 / 3.0, 16777217.0,
                            -16777217.0, 1e300, -1e300, 3.5e38);
  const BoxNode leaf = make_box_tree(std::vector<Box>{{{x, x, x}, {x, x, x}}}).nodes[0];
  const float infinity = std::numeric_limits<float>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CAPTURE(x, leaf.lo[axis], leaf.hi[axis]);
    CHECK(leaf.lo[axis] <= x);
    CHECK(leaf.hi[axis] >= x);
    CHECK((leaf.hi[axis] == x || std::nextafter(leaf.hi[axis], -infinity) < x));
    CHECK((leaf.lo[axis] == x || std::nextafter(leaf.lo[axis], infinity) > x));
  }
}

TEST_CASE("boxes that touch overlap, those apart on any axis do not", "[contact][box_tree]") {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Box other = box;
    other.lo[axis] = 1.0, other.hi[axis] = 2.0;
    CHECK(do_overlap(box, other));
    CHECK(do_overlap(other, box));
    other.lo[axis] = std::nextafter(1.0, 2.0);
    CHECK_FALSE(do_overlap(box, other));
    CHECK_FALSE(do_overlap(other, box));
  }
}

TEST_CASE("a box with a NaN, an infinity or its walls swapped is not sound", "[contact][box_tree]") {
  const Box box{{0, 0, 0}, {1, 0, 1}};
  CHECK(is_sound(box));
  const std::size_t axis = GENERATE(0, 1, 2);
  const double bad =
      GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
               -std::numeric_limits<double>::infinity());
  Box low = box, high = box, swapped = box;
  low.lo[axis] = bad, high.hi[axis] = bad, swapped.lo[axis] = 2.0;
  CHECK_FALSE(is_sound(low));
  CHECK_FALSE(is_sound(high));
  CHECK_FALSE(is_sound(swapped));
}
