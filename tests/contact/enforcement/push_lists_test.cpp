// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/push_lists.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("each carrier has the rows that push it, in their order", "[contact][enforcement]") {
  PushLists lists;
  for (int again = 0; again < 2; ++again) {
    lists.make(4, [](const auto& take) {
      take(2, PushLists::Push{0.5, 0, {}});
      take(0, PushLists::Push{-1.0, 0, 7u});
      take(2, PushLists::Push{0.25, 1, {}});
      take(3, PushLists::Push{-0.25, 1, {}});
      take(2, PushLists::Push{0.125, 5, {}});
    });
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
  }
  lists.make(0, [](const auto&) {});
  CHECK(lists.n_carriers() == 0);
}
