// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel/equal_shares.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a range ends where its end is nearest to its part of the whole", "[core][equal_shares]") {
  CHECK(equal_shares(std::vector<double>(12, 1.0), 3) == std::vector<std::size_t>{0, 4, 8, 12});
  CHECK(equal_shares(std::vector<double>{1, 1, 1, 9}, 2) == std::vector<std::size_t>{0, 3, 4});
  CHECK(equal_shares(std::vector<double>{9, 1, 1, 1}, 2) == std::vector<std::size_t>{0, 1, 4});
  // The second of 2 + 5 ends at 7, nearer to half of 11 than 2 is.
  CHECK(equal_shares(std::vector<double>{2, 5, 4}, 2) == std::vector<std::size_t>{0, 2, 3});
}

TEST_CASE("more ranks than items leave ranks without any", "[core][equal_shares]") {
  const auto begins = equal_shares(std::vector<double>{1, 1}, 5);
  REQUIRE(begins.size() == 6);
  CHECK(begins.front() == 0);
  CHECK(begins.back() == 2);
  CHECK(std::is_sorted(begins.begin(), begins.end()));
  CHECK(equal_shares({}, 3) == std::vector<std::size_t>{0, 0, 0, 0});
}
