// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/hex_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/elements/solid/base_vectors.hpp"
#include "core/mesh/element_checks.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Natural coordinates of the nodes.
constexpr double natural[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

/// Distorted unit cubes, another in every lane.
NodeVectors<8> distorted_cubes() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.15, 0.15);
  NodeVectors<8> x;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node) {
      for (int lane = 0; lane < n_lanes; ++lane) x[i][node](lane) = 0.5 * natural[node][i] + shift(random);
    }
  }
  return x;
}

/// The volume by the program's other formula.
double volume_of(const NodeVectors<8>& x, int lane) {
  Eigen::Matrix3Xd coordinates(3, 8);
  std::vector<NodeIndex> nodes;
  for (std::uint32_t node = 0; node < 8; ++node) {
    for (std::size_t i = 0; i < 3; ++i) coordinates(static_cast<Eigen::Index>(i), node) = x[i][node](lane);
    nodes.push_back({node});
  }
  return solid_volume(coordinates, nodes, topology(Shape::hex8));
}

/// A base vector at a node, as defined.
double base(std::size_t k, std::size_t node) {
  const double xi = natural[node][0], eta = natural[node][1], zeta = natural[node][2];
  const double values[] = {xi, eta, zeta, eta * zeta, xi * zeta, xi * eta, xi * eta * zeta};
  return values[k];
}

/// Volume of hexahedra with these coordinates, and its gradient by those of the nodes.
Lanes volume_by_sums(const NodeVectors<8>& x) {
  const NodeVectors<7> sums = base_sums<HexGeometry>(x);
  return dot(HexGeometry::volume_gradient(sums)[0], sums[0]);
}
NodeVectors<8> nodal_gradient(const NodeVectors<8>& x) {
  const NodeVectors<6> by_sums = HexGeometry::volume_gradient(base_sums<HexGeometry>(x));
  NodeVectors<8> gradient;
  for (std::size_t i = 0; i < 3; ++i) {
    HexSums amounts;
    std::copy_n(by_sums[i].begin(), 6, amounts.begin());
    amounts[6].setZero();
    gradient[i] = HexGeometry::at_nodes(amounts);
  }
  return gradient;
}

}  // namespace

TEST_CASE("the volume of a distorted hexahedron is that of its faces' cones", "[core][elements]") {
  const NodeVectors<8> x = distorted_cubes();
  const Lanes volume = volume_by_sums(x);
  for (int lane = 0; lane < n_lanes; ++lane) CHECK(volume(lane) == Approx(volume_of(x, lane)).epsilon(1e-12));
}

TEST_CASE("the volume gradient is the difference quotient of the volume", "[core][elements]") {
  const NodeVectors<8> x = distorted_cubes();
  const NodeVectors<8> gradient = nodal_gradient(x);
  constexpr double h = 1e-3;  // the volume is linear in each coordinate: any step is exact
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node) {
      NodeVectors<8> moved = x;
      moved[i][node] += h;
      for (int lane = 0; lane < n_lanes; ++lane) {
        CHECK(gradient[i][node](lane) ==
              Approx((volume_of(moved, lane) - volume_of(x, lane)) / h).epsilon(1e-9).margin(1e-11));
      }
    }
  }
}

TEST_CASE("far from the origin the volume loses nothing that the coordinates have not lost",
          "[core][elements]") {
  NodeVectors<8> near = distorted_cubes(), far;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node) {
      for (int lane = 0; lane < n_lanes; ++lane)  // of few digits, so that a shift is exact
        near[i][node](lane) = std::round(near[i][node](lane) * 1024.0) / 1024.0;
      far[i][node] = near[i][node] + (i == 1 ? -3e6 : 1e6);
    }
  }
  CHECK((volume_by_sums(far) == volume_by_sums(near)).all());
}

TEST_CASE("gradients of a linear field are exact whatever the shape", "[core][elements]") {
  const NodeVectors<8> x = distorted_cubes();
  const NodeVectors<8> gradient = nodal_gradient(x);
  const Lanes volume = dot(x[0], gradient[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Lanes expected = i == j ? volume : Lanes::Zero();
      CHECK((dot(x[i], gradient[j]) - expected).abs().maxCoeff() < 1e-15);
    }
  }
}

TEST_CASE("sums with the base vectors and their transpose are the products with the signs",
          "[core][elements]") {
  const std::array<Lanes, 8> values = distorted_cubes()[0];
  const HexSums sums = HexGeometry::base_sums(values);
  for (std::size_t k = 0; k < sums.size(); ++k) {
    Lanes expected = Lanes::Zero();
    for (std::size_t node = 0; node < 8; ++node) expected += base(k, node) * values[node];
    CHECK((sums[k] - expected).abs().maxCoeff() < 1e-15);
  }
  const std::array<Lanes, 8> at_nodes = HexGeometry::at_nodes(sums);
  for (std::size_t node = 0; node < 8; ++node) {
    Lanes expected = Lanes::Zero();
    for (std::size_t k = 0; k < sums.size(); ++k) expected += base(k, node) * sums[k];
    CHECK((at_nodes[node] - expected).abs().maxCoeff() < 1e-14);
  }
}

TEST_CASE("the base vectors of hexahedra are orthogonal and as long as they say", "[core][elements]") {
  for (std::size_t k = 0; k < HexGeometry::n_base; ++k) {
    for (std::size_t l = 0; l < HexGeometry::n_base; ++l) {
      double product = 0.0;
      for (std::size_t node = 0; node < 8; ++node) product += base(k, node) * base(l, node);
      CHECK(product == (k == l ? HexGeometry::base_norm : 0.0));
    }
  }
  CHECK(HexGeometry::mode_norm == std::sqrt(HexGeometry::base_norm));
}

TEST_CASE("hourglass modes of hexahedra are the last four base vectors", "[core][elements]") {
  const HexSums sums = HexGeometry::base_sums(distorted_cubes()[0]);
  const std::array<Lanes, 4> modes = HexGeometry::mode_sums(sums);
  HexSums added = sums;
  HexGeometry::add_modes(modes, added);
  for (std::size_t k = 0; k < sums.size(); ++k) CHECK((added[k] == (k < 3 ? sums[k] : 2.0 * sums[k])).all());
  for (std::size_t k = 0; k < 4; ++k) CHECK((modes[k] == sums[3 + k]).all());
}
