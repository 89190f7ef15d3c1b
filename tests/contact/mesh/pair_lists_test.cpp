// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/pair_lists.hpp"

#include <random>

#include "support/catch.hpp"
#include "support/moving_boxes.hpp"

using namespace contactsim;

TEST_CASE("pairs are listed by row, partners ascending, rows without partners empty",
          "[contact][pair_lists]") {
  const std::vector<FoundPairs> parts = {
      {{{3, 1}, {0, 7}}, 0, 0}, {{}, 0, 0}, {{{3, 0}, {0, 2}, {3, 5}}, 0, 0}};
  PairLists lists;
  list_pairs(parts, 5, lists);
  CHECK(lists.begin == std::vector<std::uint32_t>{0, 2, 2, 2, 5, 5});
  CHECK(lists.partners == std::vector<std::uint32_t>{2, 7, 0, 1, 5});
  CHECK(lists.n_rows() == 5);
  CHECK(std::vector<std::uint32_t>(lists.of(3).begin(), lists.of(3).end()) ==
        std::vector<std::uint32_t>{0, 1, 5});
  CHECK(lists.of(4).empty());
}

TEST_CASE("lists forget what they held", "[contact][pair_lists]") {
  PairLists lists;
  list_pairs(std::vector<FoundPairs>{{{{0, 1}, {1, 2}}, 0, 0}}, 2, lists);
  list_pairs({}, 1, lists);
  CHECK(lists.begin == std::vector<std::uint32_t>{0, 0});
  CHECK(lists.partners.empty());
}

TEST_CASE("100,000 pairs come out as a sort has them", "[contact][pair_lists]") {
  std::mt19937 random(1);
  std::vector<FoundPairs> parts(7);
  std::vector<RowPartner> all;
  for (std::uint32_t i = 0; i < 100000; ++i) {
    const RowPartner pair{static_cast<std::uint32_t>(random() % 1000), i};
    parts[random() % parts.size()].pairs.push_back(pair);
    all.push_back(pair);
  }
  PairLists lists;
  list_pairs(parts, 1000, lists);
  const PairLists expected = test::in_rows(all, 1000);
  CHECK(lists.begin == expected.begin);
  CHECK(lists.partners == expected.partners);
}
