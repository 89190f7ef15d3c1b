// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/bisect_points.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;
using Parts = std::vector<std::uint32_t>;

TEST_CASE("points are divided across the longest side", "[io][decompose]") {
  Eigen::Matrix3Xd points(3, 6);
  points << 0, 1, 0, 1, 0, 1,  // x
      0, 0, 9, 9, 4, 4,        // y
      0, 0, 0, 0, 0, 0;        // z
  CHECK(bisect_points(points, 1) == Parts{0, 0, 0, 0, 0, 0});
  CHECK(bisect_points(points, 3) == Parts{0, 0, 2, 2, 1, 1});
  CHECK(bisect_points(points, 6) == Parts{0, 1, 4, 5, 2, 3});
}

TEST_CASE("points at one place are divided in their order", "[io][decompose]") {
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Ones(3, 5);
  CHECK(bisect_points(points, 2) == Parts{0, 0, 1, 1, 1});
  CHECK(bisect_points(points, 5) == Parts{0, 1, 2, 3, 4});
  CHECK(bisect_points(Eigen::Matrix3Xd(3, 0), 3).empty());
}

TEST_CASE("parts differ by one point at most", "[io][decompose]") {
  Eigen::Matrix3Xd points(3, 1000);
  for (int i = 0; i < 1000; ++i) points.col(i) << i * 37 % 101, i * 53 % 97, i * 71 % 89;
  const std::uint32_t n_parts = GENERATE(2u, 3u, 7u, 16u, 999u);
  const Parts parts = bisect_points(points, n_parts);
  std::vector<int> counts(n_parts, 0);
  for (const std::uint32_t part : parts) ++counts.at(part);
  const auto [least, most] = std::ranges::minmax(counts);
  CHECK(most - least <= 1);
}
