// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/threads.hpp"

#include <cstdint>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("few items are not worth a second thread", "[threads]") {
  CHECK(threads_for(0) == 1);
  CHECK(threads_for(19999) == 1);
  CHECK(threads_for(std::size_t{1} << 40) == omp_get_max_threads());
}

TEST_CASE("parallel loops visit every item once with any number of threads", "[threads]") {
  const int n_threads = GENERATE(1, 2, 3, 8);
  const std::size_t n = GENERATE(0, 1, 2, 7, 1000);
  std::vector<int> even(n, 0), uneven(n, 0), ranges(n, 0);
  parallel_for(n, n_threads, [&](std::size_t i) { ++even[i]; });
  parallel_for_uneven(n, n_threads, [&](std::size_t i) { ++uneven[i]; });
  parallel_for_ranges(static_cast<std::int64_t>(n), n_threads, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) ++ranges[static_cast<std::size_t>(i)];
  });
  const std::vector<int> once(n, 1);
  CHECK(even == once);
  CHECK(uneven == once);
  CHECK(ranges == once);
}

TEST_CASE("the least of a parallel loop is never above its start", "[threads]") {
  const int n_threads = GENERATE(1, 2, 5);
  const auto distance_to_70 = [](int i) { return i < 70 ? 70 - i : i - 69; };
  CHECK(parallel_min(100, n_threads, 1000, distance_to_70) == 1);
  CHECK(parallel_min(100, n_threads, -3, distance_to_70) == -3);
  CHECK(parallel_min(0, n_threads, 5, distance_to_70) == 5);
}
