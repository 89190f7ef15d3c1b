// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/push_lists.hpp"

#include <random>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

struct Taken {
  std::uint32_t carrier = 0;
  RowPush push;
};

/// Lists of pushes that come in items of their own.
PushLists<RowPush> lists_of(std::size_t n_carriers, int n_threads, const std::vector<Taken>& taken) {
  PushLists<RowPush> lists;
  for (int again = 0; again < 2; ++again) {
    lists.make(n_carriers, taken.size(), n_threads,
               [&](std::size_t begin, std::size_t end, const auto& take) {
                 for (std::size_t i = begin; i < end; ++i) take(taken[i].carrier, taken[i].push);
               });
  }
  return lists;
}

}  // namespace

TEST_CASE("each carrier has the rows that push it, in their order", "[contact][enforcement]") {
  const std::vector<Taken> taken{
      {2, {0.5, 0, {}}}, {0, {-1.0, 0, 7u}}, {2, {0.25, 1, {}}}, {3, {-0.25, 1, {}}}, {2, {0.125, 5, {}}}};
  for (const int n_threads : {1, 2, 3, 7}) {
    INFO(n_threads << " threads");
    const PushLists<RowPush> lists = lists_of(4, n_threads, taken);
    REQUIRE(lists.n_carriers() == 4);
    CHECK(lists.of(1).empty());
    REQUIRE(lists.of(2).size() == 3);
    CHECK(lists.of(2)[0].weight == 0.5);
    CHECK(lists.of(2)[1].row == 1);
    CHECK(lists.of(2)[2].row == 5);
    CHECK_FALSE(lists.of(2)[2].arm);
    REQUIRE(lists.of(0).size() == 1);
    CHECK(*lists.of(0)[0].arm == 7);
    CHECK(lists.of(3)[0].weight == -0.25);
    CHECK(lists_of(0, n_threads, {}).n_carriers() == 0);
  }
  CHECK(PushLists<RowPush>().n_carriers() == 0);
}

TEST_CASE("lists of pushes are those of a stable sort for any number of threads", "[contact][enforcement]") {
  std::mt19937 random(17);
  std::vector<Taken> taken;
  for (std::uint32_t row = 0; row < 500; ++row)
    taken.push_back({static_cast<std::uint32_t>(random() % 40), {0.5 * row, row, {}}});
  std::vector<Taken> sorted = taken;
  std::ranges::stable_sort(sorted, {}, &Taken::carrier);
  for (const int n_threads : {1, 2, 5, 16}) {
    const PushLists<RowPush> lists = lists_of(40, n_threads, taken);
    auto expected = sorted.begin();
    for (std::uint32_t carrier = 0; carrier < 40; ++carrier) {
      for (const RowPush& push : lists.of(carrier)) {
        REQUIRE(expected != sorted.end());
        REQUIRE(expected->carrier == carrier);
        REQUIRE(push.row == expected++->push.row);
      }
    }
    REQUIRE(expected == sorted.end());
  }
}
