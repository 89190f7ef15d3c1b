// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/bvh_pairs.hpp"

#include <mutex>

#include "contact/search/broad_phase.hpp"
#include "support/catch.hpp"
#include "support/moving_boxes.hpp"
#include "support/thread_ranks.hpp"

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

TEST_CASE("ranks that search together find the pairs of one, after as many visits", "[contact][bvh_pairs]") {
  const BoxTree tree = make_box_tree(MovingBoxes(5000, 1).boxes());
  const auto keep = [](std::uint32_t row, std::uint32_t partner) { return (row + partner) % 2 == 0; };
  const auto alone = find_bvh_pairs<true>(tree, tree, keep);
  PairTable expected;
  list_pairs(alone, tree.n_boxes(), expected);
  std::uint64_t visits = 0, overlaps = 0;
  for (const FoundPairs& part : alone) {
    visits += part.visits;
    overlaps += part.overlaps;
  }
  REQUIRE(expected.partners.size() > 1000);
  std::mutex checking;
  test::ThreadRanks(GENERATE(2, 3, 7)).run([&](Ranks& ranks) {
    const auto together = find_bvh_pairs<true>(tree, tree, keep, ranks);
    const std::lock_guard lock(checking);
    REQUIRE(together.size() == 1);
    CHECK(together[0].visits == visits);
    CHECK(together[0].overlaps == overlaps);
    PairTable found;
    list_pairs(together, tree.n_boxes(), found);
    CHECK(found.begin == expected.begin);
    CHECK(found.partners == expected.partners);
  });
}
