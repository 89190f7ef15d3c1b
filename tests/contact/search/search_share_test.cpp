// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/search_share.hpp"

#include <mutex>

#include "support/catch.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;

TEST_CASE("one rank, or few boxes, are searched by each rank as a whole", "[contact][search_share]") {
  const SearchShare alone(one_rank(), 1000000);
  CHECK_FALSE(alone.is_shared());
  CHECK(alone.has(0));
  CHECK(alone.has(1));
  std::vector<FoundPairs> parts(2);
  parts[1].pairs.push_back({4, 5});
  CHECK(alone.gather(parts).size() == 2);
  test::ThreadRanks(2).run([&](Ranks& ranks) {
    const SearchShare few(ranks, 100);
    if (few.is_shared() || !few.has(0) || !few.has(1) || few.gather(parts).size() != 2)
      throw std::logic_error("few boxes are shared");
  });
}

TEST_CASE("each part of a search has one rank, and all ranks get what was found", "[contact][search_share]") {
  constexpr std::size_t n_parts = 10;
  std::vector<int> n_owners(n_parts, 0);
  std::mutex checking;
  test::ThreadRanks(3).run([&](Ranks& ranks) {
    const SearchShare share(ranks, 5000);
    std::vector<FoundPairs> own(n_parts);
    for (std::uint32_t i = 0; i < n_parts; ++i) {
      if (!share.has(i)) continue;
      own[i].pairs = {{i, i + 1}, {i, i + 2}};
      own[i].visits = 1;
      own[i].overlaps = 10;
      const std::lock_guard lock(checking);
      ++n_owners[i];
    }
    const auto all = share.gather(own);
    const std::lock_guard lock(checking);
    REQUIRE(all.size() == 1);
    CHECK(all[0].visits == n_parts);
    CHECK(all[0].overlaps == 10 * n_parts);
    std::vector<int> n_found(n_parts, 0);
    for (const RowPartner& pair : all[0].pairs) ++n_found[pair.row];
    CHECK(n_found == std::vector<int>(n_parts, 2));
  });
  CHECK(n_owners == std::vector<int>(n_parts, 1));
}
