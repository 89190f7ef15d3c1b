// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel/ranks.hpp"

#include <atomic>

#include "core/parallel/on_root.hpp"
#include "support/catch.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using contactsim::test::ThreadRanks;

TEST_CASE("a process by itself is the root of one rank", "[core][ranks]") {
  CHECK(one_rank().is_root());
  CHECK_FALSE(one_rank().are_several());
  CHECK(one_rank().of_root(3.5) == 3.5);
  CHECK(one_rank().of_all(7) == std::vector<int>{7});
  CHECK(one_rank().wait_for_all(0.0));
}

TEST_CASE("ranks know the value of the root and those of all", "[core][ranks]") {
  std::atomic<int> n_right = 0;
  ThreadRanks(3).run([&](Ranks& ranks) {
    const bool is_right = ranks.of_root(10 + ranks.rank()) == 10 &&
                          ranks.of_all(10 + ranks.rank()) == std::vector<int>{10, 11, 12};
    n_right += is_right ? 1 : 0;
  });
  CHECK(n_right == 3);
}

TEST_CASE("what any rank marks is marked on all", "[core][ranks]") {
  constexpr std::size_t n = 150;  // more than two words, the last one not full
  std::atomic<int> n_right = 0;
  ThreadRanks(3).run([&](Ranks& ranks) {
    std::vector<std::uint8_t> marks(n, 0), expected(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      marks[i] = i % 5 == static_cast<std::size_t>(ranks.rank()) ? 1 : 0;
      expected[i] = i % 5 < 3 ? 1 : 0;
    }
    ranks.unite(marks);
    n_right += marks == expected ? 1 : 0;
  });
  CHECK(n_right == 3);
}

TEST_CASE("what the root alone does fails on all ranks", "[core][ranks]") {
  std::atomic<int> n_done = 0, n_failed = 0;
  ThreadRanks(3).run([&](Ranks& ranks) {
    on_root(ranks, [&] { ++n_done; });
    try {
      on_root(ranks, [] { throw FileError("results.e", "no space left"); });
    } catch (const FileError&) {
      ++n_failed;
    }
  });
  CHECK(n_done == 1);
  CHECK(n_failed == 3);
}

TEST_CASE("what one rank fails in fails on all ranks, and all know why", "[core][ranks]") {
  std::atomic<int> n_told = 0;
  ThreadRanks(3).run([&](Ranks& ranks) {
    try {
      on_each(ranks, [&] {
        if (ranks.rank() == 2) throw FileError("results.e.3.2", "no space left");
      });
    } catch (const FileError& error) {
      const std::string told = error.what();
      n_told += told.ends_with("results.e.3.2: no space left") ? 1 : 0;
    }
  });
  CHECK(n_told == 3);
}

TEST_CASE("lists of different lengths are joined in the order of the ranks", "[core][ranks]") {
  CHECK(one_rank().join(std::vector<int>{4, 2}) == std::vector<int>{4, 2});
  std::atomic<int> n_right = 0;
  ThreadRanks(3).run([&](Ranks& ranks) {
    const std::vector<int> own(static_cast<std::size_t>(2 * (ranks.rank() % 2)), 10 + ranks.rank());
    n_right += ranks.join(own) == std::vector<int>{11, 11} ? 1 : 0;
    n_right += ranks.join(std::vector<int>{ranks.rank()}) == std::vector<int>{0, 1, 2} ? 1 : 0;
  });
  CHECK(n_right == 6);
}
