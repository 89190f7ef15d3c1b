// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/hex_points.hpp"

#include <cmath>
#include <random>

#include "core/elements/solid/base_vectors.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr double corner_points[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

NodeVectors<8> distorted_cubes(double distortion) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-distortion, distortion);
  NodeVectors<8> x;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node) {
      for (int lane = 0; lane < n_lanes; ++lane)
        x[i][node](lane) = 0.5 * corner_points[node][i] + shift(random);
    }
  }
  return x;
}

/// Derivative of a node's shape function along a corner_points coordinate at a point.
double shape_slope(std::size_t node, std::size_t point, std::size_t along) {
  double product = 0.125;
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = ((point >> k & 1) != 0 ? 1.0 : -1.0) / std::sqrt(3.0);
    product *= k == along ? corner_points[node][k] : 1.0 + corner_points[node][k] * at;
  }
  return product;
}

}  // namespace

TEST_CASE("natural slopes are those of the trilinear shape functions", "[core][elements]") {
  const std::array<Lanes, 8> values = distorted_cubes(1.0)[0];
  const NaturalSlopes slopes = natural_slopes(HexGeometry::base_sums(values));
  for (std::size_t point = 0; point < n_hex_points; ++point) {
    for (std::size_t along = 0; along < 3; ++along) {
      Lanes expected = Lanes::Zero();
      for (std::size_t node = 0; node < 8; ++node) expected += shape_slope(node, point, along) * values[node];
      CHECK((slopes[along][signs_at(point, along)] - expected).abs().maxCoeff() < 1e-15);
    }
  }
}

TEST_CASE("what slopes put on the nodes is the transpose of taking slopes", "[core][elements]") {
  const std::array<Lanes, 8> values = distorted_cubes(1.0)[0];
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  NaturalSlopes amounts;
  for (auto& along : amounts) {
    for (Lanes& amount : along) {
      for (Eigen::Index lane = 0; lane < n_lanes; ++lane) amount(lane) = number(random);
    }
  }
  HexSums sums;
  sums.fill(Lanes::Constant(1.0));
  add_from_slopes(amounts, sums);
  for (Lanes& sum : sums) sum -= 1.0;
  const std::array<Lanes, 8> added = HexGeometry::at_nodes(sums);
  Lanes by_slopes = Lanes::Zero(), by_nodes = Lanes::Zero();
  const NaturalSlopes slopes = natural_slopes(HexGeometry::base_sums(values));
  for (std::size_t along = 0; along < 3; ++along) {
    for (std::size_t signs = 0; signs < 4; ++signs) by_slopes += slopes[along][signs] * amounts[along][signs];
  }
  for (std::size_t node = 0; node < 8; ++node) by_nodes += values[node] * added[node];
  CHECK((by_slopes - by_nodes).abs().maxCoeff() < 1e-14);
}

TEST_CASE("the points' volumes add up to the hexahedron, unless one is inside out", "[core][elements]") {
  NodeVectors<8> x = distorted_cubes(0.1);
  const auto sums = [&] { return base_sums<HexGeometry>(x); };
  const auto whole = [&] { return dot(HexGeometry::volume_gradient(sums())[0], sums()[0]); };
  CHECK((volume_of_points(vector_slopes(sums())) - whole()).abs().maxCoeff() < 1e-14);
  for (std::size_t i = 0; i < 3; ++i) x[i][6] = Lanes::Constant(-0.3);  // a dent past the middle
  CHECK((whole() > 0.0).all());
  CHECK((volume_of_points(vector_slopes(sums())) < 0.0).all());
}
