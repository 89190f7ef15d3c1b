// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/bvh_pairs.hpp"

#include "contact/search/broad_phase.hpp"
#include "support/catch.hpp"
#include "support/moving_boxes.hpp"

using namespace contactsim;
using test::MovingBoxes;

TEST_CASE("the work is cut into parts of about equal size for threads", "[contact][bvh_pairs]") {
  const BoxTree tree = make_box_tree(MovingBoxes(5000, 1).boxes());
  const auto pairs = BvhPairs<false>(tree, tree).cut();
  const auto self_pairs = BvhPairs<true>(tree, tree).cut();
  CHECK(pairs.size() >= 256);
  CHECK(self_pairs.size() >= 256);
  CHECK(self_pairs.size() < 1024);
  for (const BvhNodePair pair : self_pairs) CHECK(tree.nodes[pair.row].n_boxes < 5000 / 4);
}

TEST_CASE("trees apart have no pairs and take no visits", "[contact][bvh_pairs]") {
  const BoxTree tree = make_box_tree(MovingBoxes(100, 1).boxes());
  const BoxTree far = make_box_tree(std::vector<Box>(100, Box{{9, 9, 9}, {10, 10, 10}}));
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  CHECK(find_bvh_pairs<false>(tree, far, all).empty());
}

TEST_CASE("a tree of one box meets itself in no pair", "[contact][bvh_pairs]") {
  const BoxTree tree = make_box_tree(MovingBoxes(1, 1).boxes());
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  const auto of_itself = find_bvh_pairs<true>(tree, tree, all);
  REQUIRE(of_itself.size() == 1);
  CHECK(of_itself[0].pairs.empty());
  CHECK(find_bvh_pairs<false>(tree, tree, all)[0].pairs.size() == 1);
}
