// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/hex_geometry.hpp"

#include <random>
#include <vector>

#include "core/elements/solid/midpoint_kinematics.hpp"
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

double mode(std::size_t alpha, std::size_t node) {
  const double xi = natural[node][0], eta = natural[node][1], zeta = natural[node][2];
  const double values[] = {eta * zeta, xi * zeta, xi * eta, xi * eta * zeta};
  return values[alpha];
}

}  // namespace

TEST_CASE("the volume of a distorted hexahedron is that of its faces' cones", "[core][elements]") {
  const NodeVectors<8> x = distorted_cubes();
  const Lanes volume = dot(x[0], HexGeometry::volume_gradient(x)[0]);
  for (int lane = 0; lane < n_lanes; ++lane) CHECK(volume(lane) == Approx(volume_of(x, lane)).epsilon(1e-12));
}

TEST_CASE("the volume gradient is the difference quotient of the volume", "[core][elements]") {
  const NodeVectors<8> x = distorted_cubes();
  const NodeVectors<8> gradient = HexGeometry::volume_gradient(x);
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

TEST_CASE("gradients of a linear field are exact whatever the shape", "[core][elements]") {
  const NodeVectors<8> x = distorted_cubes();
  const NodeVectors<8> gradient = HexGeometry::volume_gradient(x);
  const Lanes volume = dot(x[0], gradient[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Lanes expected = i == j ? volume : Lanes::Zero();
      CHECK((dot(x[i], gradient[j]) - expected).abs().maxCoeff() < 1e-15);
    }
  }
}

TEST_CASE("hourglass sums and their transpose are the products with the patterns", "[core][elements]") {
  const std::array<Lanes, 8> values = distorted_cubes()[0];
  const std::array<Lanes, 4> sums = HexGeometry::mode_sums(values);
  for (std::size_t alpha = 0; alpha < 4; ++alpha) {
    Lanes expected = Lanes::Zero();
    for (std::size_t node = 0; node < 8; ++node) expected += mode(alpha, node) * values[node];
    CHECK((sums[alpha] - expected).abs().maxCoeff() < 1e-15);
  }
  std::array<Lanes, 8> added;
  for (Lanes& value : added) value.setZero();
  HexGeometry::add_modes(sums, added);
  for (std::size_t node = 0; node < 8; ++node) {
    Lanes expected = Lanes::Zero();
    for (std::size_t alpha = 0; alpha < 4; ++alpha) expected += mode(alpha, node) * sums[alpha];
    CHECK((added[node] - expected).abs().maxCoeff() < 1e-15);
  }
}
