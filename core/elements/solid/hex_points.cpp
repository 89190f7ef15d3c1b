// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/hex_points.hpp"

namespace contactsim {

namespace {

constexpr double at = 0.57735026918962573;  // 1 / sqrt(3)
constexpr double eighth = 0.125;

/// What the sums of a field are times as its coefficients of xi, eta, zeta, eta zeta, xi zeta, xi eta, xi eta
/// zeta, the products scaled to the points.
constexpr std::array<double, 7> share = {eighth,     eighth,     eighth,        eighth* at,
                                         eighth* at, eighth* at, eighth* at* at};

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

NaturalSlopes natural_slopes(const HexSums& sums) {
  HexSums m;
  for (std::size_t k = 0; k < m.size(); ++k) m[k] = sums[k] * share[k];
  return {spread(m[0], m[5], m[4], m[6]), spread(m[1], m[5], m[3], m[6]), spread(m[2], m[4], m[3], m[6])};
}

void add_from_slopes(const NaturalSlopes& amounts, HexSums& forces) {
  HexSums m;
  for (std::size_t k = 3; k < m.size(); ++k) m[k].setZero();
  collect(amounts[0], m[0], m[5], m[4], m[6]);
  collect(amounts[1], m[1], m[5], m[3], m[6]);
  collect(amounts[2], m[2], m[4], m[3], m[6]);
  for (std::size_t k = 0; k < m.size(); ++k) forces[k] += m[k] * share[k];
}

VectorSlopes vector_slopes(const NodeVectors<7>& sums) {
  return {natural_slopes(sums[0]), natural_slopes(sums[1]), natural_slopes(sums[2])};
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
