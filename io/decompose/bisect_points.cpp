// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/bisect_points.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace contactsim {

namespace {

/// Divides some of the points into parts first_part, first_part + 1, ...
void bisect(const Eigen::Matrix3Xd& points, std::span<std::uint32_t> some, std::uint32_t first_part,
            std::uint32_t n_parts, std::vector<std::uint32_t>& parts) {
  if (n_parts == 1 || some.empty()) {
    for (const std::uint32_t point : some) parts[point] = first_part;
    return;
  }
  Eigen::Vector3d low = points.col(some.front()), high = low;
  for (const std::uint32_t point : some) {
    low = low.cwiseMin(points.col(point));
    high = high.cwiseMax(points.col(point));
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::uint32_t n_lower = n_parts / 2;
  const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() * n_lower / n_parts);
  std::nth_element(some.begin(), middle, some.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double of_a = points(axis, a), of_b = points(axis, b);
    return of_a < of_b || (of_a == of_b && a < b);
  });
  bisect(points, {some.begin(), middle}, first_part, n_lower, parts);
  bisect(points, {middle, some.end()}, first_part + n_lower, n_parts - n_lower, parts);
}

}  // namespace

std::vector<std::uint32_t> bisect_points(const Eigen::Matrix3Xd& points, std::uint32_t n_parts) {
  std::vector<std::uint32_t> all(static_cast<std::size_t>(points.cols())), parts(all.size(), 0);
  std::iota(all.begin(), all.end(), 0);
  bisect(points, all, 0, n_parts, parts);
  return parts;
}

}  // namespace contactsim
