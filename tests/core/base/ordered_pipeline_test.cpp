// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/ordered_pipeline.hpp"

#include <numeric>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Work that takes longer the larger the number.
double busy(std::size_t n) {
  double sum = 0.0;
  for (std::size_t i = 1; i <= n; ++i) sum += 1.0 / static_cast<double>(i);
  return sum;
}

}  // namespace

TEST_CASE("items are taken in order, each as it was made", "[base]") {
  const int n_threads = GENERATE(1, 2, 3, 8);
  const std::size_t n = GENERATE(0, 1, 2, 17, 500);
  OrderedPipeline<std::vector<double>> pipeline;
  for (int run = 0; run < 2; ++run) {
    std::vector<double> taken;
    pipeline.run(
        n, n_threads,
        [](std::size_t i, std::vector<double>& item) {
          // Every seventh takes far longer: later ones are made before it.
          item.assign(1 + i % 3, busy(i % 7 == 0 ? 20000 : 10) + static_cast<double>(i));
        },
        [&](std::size_t i, const std::vector<double>& item) {
          REQUIRE(item.size() == 1 + i % 3);
          taken.push_back(item.front());
        });
    REQUIRE(taken.size() == n);
    for (std::size_t i = 0; i < n; ++i)
      CHECK(taken[i] == busy(i % 7 == 0 ? 20000 : 10) + static_cast<double>(i));
  }
}

TEST_CASE("what is taken may be slow: threads wait before they run out of room", "[base]") {
  OrderedPipeline<std::size_t> pipeline;
  std::vector<std::size_t> taken;
  pipeline.run(
      300, 3, [](std::size_t i, std::size_t& item) { item = i; },
      [&](std::size_t, std::size_t item) {
        if (busy(3000) > 0.0) taken.push_back(item);
      });
  std::vector<std::size_t> all(300);
  std::iota(all.begin(), all.end(), 0);
  CHECK(taken == all);
}
