// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/hex_points.hpp"

namespace contactsim {

namespace {

constexpr double at = 0.57735026918962573;  // 1 / sqrt(3)
constexpr double eighth = 0.125;

/// Coefficients of xi, eta, zeta, eta zeta, xi zeta, xi eta, xi eta zeta, the products scaled to the points.
using Modes = std::array<Lanes, 7>;

Modes modes_of(const std::array<Lanes, 8>& v) {
  const Lanes s0 = v[4] + v[0], s1 = v[5] + v[1], s2 = v[6] + v[2], s3 = v[7] + v[3];
  const Lanes d0 = v[4] - v[0], d1 = v[5] - v[1], d2 = v[6] - v[2], d3 = v[7] - v[3];
  const Lanes s10 = s1 - s0, s23 = s2 - s3, d10 = d1 - d0, d23 = d2 - d3;
  const Lanes d01 = d0 + d1, d32 = d3 + d2;
  return {(s10 + s23) * eighth,
          (s3 - s0 + s2 - s1) * eighth,
          (d01 + d32) * eighth,
          (d32 - d01) * (eighth * at),
          (d10 + d23) * (eighth * at),
          (s23 - s10) * (eighth * at),
          (d23 - d10) * (eighth * at * at)};
}

/// Values of constant + first * x + second * y + product * x y for the signs of x and y.
std::array<Lanes, 4> spread(const Lanes& constant, const Lanes& first, const Lanes& second,
                            const Lanes& product) {
  const Lanes low = constant - second, high = constant + second;
  const Lanes low_first = first - product, high_first = first + product;
  return {low - low_first, low + low_first, high - high_first, high + high_first};
}

/// The transpose of spread().
void collect(const std::array<Lanes, 4>& q, Lanes& constant, Lanes& first, Lanes& second, Lanes& product) {
  const Lanes low = q[0] + q[1], high = q[2] + q[3], low_first = q[1] - q[0], high_first = q[3] - q[2];
  constant = low + high;
  second += high - low;
  first += low_first + high_first;
  product += high_first - low_first;
}

}  // namespace

NaturalSlopes natural_slopes(const std::array<Lanes, 8>& values) {
  const Modes m = modes_of(values);
  return {spread(m[0], m[5], m[4], m[6]), spread(m[1], m[5], m[3], m[6]), spread(m[2], m[4], m[3], m[6])};
}

void add_from_slopes(const NaturalSlopes& amounts, std::array<Lanes, 8>& v) {
  Modes m;
  for (std::size_t i = 3; i < 7; ++i) m[i].setZero();
  collect(amounts[0], m[0], m[5], m[4], m[6]);
  collect(amounts[1], m[1], m[5], m[3], m[6]);
  collect(amounts[2], m[2], m[4], m[3], m[6]);
  for (std::size_t i = 0; i < 7; ++i) m[i] *= i < 3 ? eighth : i < 6 ? eighth * at : eighth * at * at;
  // Even in zeta, then odd; within each the quadrilateral's nodes 0 to 3.
  const Lanes sum = m[0] + m[1], difference = m[0] - m[1];
  const Lanes even[4] = {m[5] - sum, difference - m[5], sum + m[5], -difference - m[5]};
  const Lanes odd_sum = m[3] + m[4], odd_difference = m[4] - m[3];
  const Lanes odd[4] = {m[2] - odd_sum + m[6], m[2] + odd_difference - m[6], m[2] + odd_sum + m[6],
                        m[2] - odd_difference - m[6]};
  for (std::size_t i = 0; i < 4; ++i) {
    v[i] += even[i] - odd[i];
    v[i + 4] += even[i] + odd[i];
  }
}

VectorSlopes vector_slopes(const NodeVectors<8>& vectors) {
  return {natural_slopes(vectors[0]), natural_slopes(vectors[1]), natural_slopes(vectors[2])};
}

TensorLanes slopes_at(const VectorSlopes& slopes, std::size_t point) {
  TensorLanes tensor;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) tensor[i][j] = slopes[i][j][signs_at(point, j)];
  }
  return tensor;
}

PointMap point_map(const VectorSlopes& coordinates, std::size_t point) {
  const TensorLanes j = slopes_at(coordinates, point);
  PointMap map;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = j[(i + 1) % 3], &b = j[(i + 2) % 3];
    map.cofactors[i] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  map.volume = j[0][0] * map.cofactors[0][0] + j[0][1] * map.cofactors[0][1] + j[0][2] * map.cofactors[0][2];
  return map;
}

Lanes volume_of_points(const VectorSlopes& coordinates) {
  Lanes min_volume = point_map(coordinates, 0).volume, sum = min_volume;
  for (std::size_t point = 1; point < n_hex_points; ++point) {
    const Lanes volume = point_map(coordinates, point).volume;
    sum += volume;
    min_volume = min_volume.min(volume);
  }
  return (min_volume > 0.0).select(sum, min_volume);
}

}  // namespace contactsim
