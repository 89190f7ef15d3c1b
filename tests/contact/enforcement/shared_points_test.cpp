// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/shared_points.hpp"

#include <array>
#include <mutex>

#include "support/catch.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;

namespace {

std::vector<ContactPoint> points_of(std::size_t chunk, std::size_t n) {
  std::vector<ContactPoint> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i].first_entity = static_cast<std::uint32_t>(100 * chunk + i);
    points[i].normal = {0.1, static_cast<double>(chunk), static_cast<double>(i)};
  }
  return points;
}

}  // namespace

TEST_CASE("one rank shares no contact points", "[contact][shared_points]") {
  SharedPoints points(one_rank());
  CHECK_FALSE(points.begin(1000));
}

TEST_CASE("ranks share contact points where there are enough", "[contact][shared_points]") {
  test::ThreadRanks(2).run([](Ranks& ranks) {
    SharedPoints points(ranks);
    if (points.begin(4)) throw std::logic_error("four chunks of nothing are shared");
    points.add(2, points_of(2, 40));
    if (!points.begin(4)) throw std::logic_error("forty points are not shared");
  });
}

TEST_CASE("shares follow what was found last, and all ranks have all points in order",
          "[contact][shared_points]") {
  constexpr std::size_t n_chunks = 40;
  // Then fewer before the points of a rank, and more again.
  const std::array<std::size_t, 5> of_first{90, 90, 80, 95, 95};
  const auto n_found = [&](std::size_t chunk, std::size_t step) {
    return chunk < 4 ? of_first[step] : chunk % 3;
  };
  std::mutex checking;
  test::ThreadRanks(3).run([&](Ranks& ranks) {
    SharedPoints points(ranks);
    std::size_t n_own = 0;
    for (std::size_t step = 0; step < of_first.size(); ++step) {
      const bool are_shared = points.begin(n_chunks);
      n_own = 0;
      for (std::size_t chunk = points.first_own(); chunk < points.end_own(); ++chunk) {
        points.add(chunk, points_of(chunk, n_found(chunk, step)));
        n_own += n_found(chunk, step);
      }
      points.gather();
      const std::lock_guard lock(checking);
      REQUIRE(are_shared);
      for (std::size_t chunk = 0; chunk < n_chunks; ++chunk) {
        const auto expected = points_of(chunk, n_found(chunk, step));
        const auto found = points.of(chunk);
        REQUIRE(found.size() == expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
          CHECK(found[i].first_entity == expected[i].first_entity);
          CHECK(found[i].normal == expected[i].normal);
        }
      }
    }
    // Equal numbers of chunks would give the first rank all four that are full.
    const std::lock_guard lock(checking);
    CHECK(n_own < 250);
  });
}
