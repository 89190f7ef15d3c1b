// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/fours.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Numbers that all differ, the k-th at place k.
std::vector<double> ascending(std::size_t n) {
  std::vector<double> numbers;
  for (std::size_t k = 0; k < n; ++k) numbers.push_back(1.0 + static_cast<double>(k));
  return numbers;
}

}  // namespace

TEST_CASE("eight vectors become lanes, wherever they stand", "[core][lanes]") {
  const std::vector<double> numbers = ascending(40);
  // Apart, in any order, twice and off the boundaries of vectors.
  const std::size_t at[] = {32, 0, 7, 7, 20, 3, 36, 13};
  const auto lanes = to_lanes([&](std::size_t lane) { return numbers.data() + at[lane]; });
  for (std::size_t lane = 0; lane < n_lanes; ++lane) {
    for (std::size_t i = 0; i < 3; ++i) CHECK(lanes[i].data()[lane] == numbers[at[lane] + i]);
  }
}

TEST_CASE("lanes become vectors whose fourth number is 0", "[core][lanes]") {
  std::array<Lanes, 3> lanes;
  const std::vector<double> numbers = ascending(3 * n_lanes);
  for (std::size_t i = 0; i < 3; ++i) std::copy_n(&numbers[n_lanes * i], n_lanes, lanes[i].data());
  for (const std::size_t first : {0u, 4u}) {
    const auto vectors = to_vectors(lanes[0], lanes[1], lanes[2], first);
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t i = 0; i < 3; ++i) CHECK(vectors[k][i] == lanes[i].data()[first + k]);
      CHECK(vectors[k][3] == 0.0);
    }
  }
}
