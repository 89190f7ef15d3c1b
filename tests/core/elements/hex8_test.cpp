// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/hex8.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr double natural[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

const ElasticLaw elastic{{160e9, 80e9}};
const HexParameters undamped{7800.0, 0.05, 0.0, 0.0, 0.0};

using Nodes = Eigen::Matrix<double, 3, 8>;

/// Unit cubes with every node moved at random, another in every lane.
HexVectors distorted_cubes(double size = 0.15) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-size, size);
  HexVectors x;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node) {
      for (int lane = 0; lane < n_lanes; ++lane) x[i][node](lane) = 0.5 * natural[node][i] + shift(random);
    }
  }
  return x;
}

Nodes lane_of(const HexVectors& values, int lane) {
  Nodes nodes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node) {
      nodes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(node)) = values[i][node](lane);
    }
  }
  return nodes;
}

/// A x + b at every node.
HexVectors mapped(const HexVectors& x, const Eigen::Matrix3d& a) {
  HexVectors result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t node = 0; node < 8; ++node)
      result[i][node] = a(row, 0) * x[0][node] + a(row, 1) * x[1][node] + a(row, 2) * x[2][node];
  }
  return result;
}

/// The motion of a step from one place to another.
HexMotion between(const HexVectors& from, const HexVectors& to, double dt) {
  HexMotion motion{to, {}, Lanes::Constant(7800.0), dt};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node) motion.v[i][node] = (to[i][node] - from[i][node]) / dt;
  }
  return motion;
}

Eigen::Matrix3d stress_of(const SymmetricLanes& s, int lane) {
  Eigen::Matrix3d matrix;
  matrix << s[0](lane), s[3](lane), s[5](lane), s[3](lane), s[1](lane), s[4](lane), s[5](lane), s[4](lane),
      s[2](lane);
  return matrix;
}

Eigen::Matrix3d rotation_of(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

}  // namespace

TEST_CASE("a small uniform strain gives Hooke's stress in any hexahedron", "[core][hex8]") {
  const HexVectors x = distorted_cubes();
  Eigen::Matrix3d strain;
  strain << 1e-7, 2e-7, -1e-7, 2e-7, -3e-7, 5e-8, -1e-7, 5e-8, 2e-7;
  HexState<ElasticLaw> state;
  const HexStep step = advance_hex8(elastic, undamped,
                                    between(x, mapped(x, Eigen::Matrix3d::Identity() + strain), 1e-6), state);
  const Eigen::Matrix3d expected = elastic.moduli.lambda() * strain.trace() * Eigen::Matrix3d::Identity() +
                                   2.0 * elastic.moduli.shear * strain;
  for (int lane = 0; lane < n_lanes; ++lane) {
    CHECK((stress_of(state.stress, lane) - expected).norm() < 1e-6 * expected.norm());
    CHECK(std::abs(step.hourglass_work(lane)) < 1e-20 * 1e11);
  }
}

TEST_CASE("a rotation in large steps turns the stress and strains nothing", "[core][hex8]") {
  const HexVectors x = distorted_cubes();
  HexState<ElasticLaw> state;
  advance_hex8(elastic, undamped, between(x, mapped(x, Eigen::Matrix3d::Identity() * (1.0 + 1e-4)), 1e-6),
               state);
  state.stress[3].setConstant(3e6);
  state.hourglass[0][1].setConstant(5.0);
  const HexState<ElasticLaw> start = state;
  constexpr int n_steps = 5;
  for (int i = 0; i < n_steps; ++i) {
    advance_hex8(elastic, undamped,
                 between(mapped(x, rotation_of(0.3 * i)), mapped(x, rotation_of(0.3 * (i + 1))), 1e-3),
                 state);
  }
  const Eigen::Matrix3d turn = rotation_of(0.3 * n_steps);
  for (int lane = 0; lane < n_lanes; ++lane) {
    const Eigen::Matrix3d expected = turn * stress_of(start.stress, lane) * turn.transpose();
    CHECK((stress_of(state.stress, lane) - expected).norm() < 1e-4);  // of stresses near 1e8
    const Eigen::Vector3d hourglass(state.hourglass[0][1](lane), state.hourglass[1][1](lane),
                                    state.hourglass[2][1](lane));
    const Eigen::Vector3d before(start.hourglass[0][1](lane), start.hourglass[1][1](lane),
                                 start.hourglass[2][1](lane));
    CHECK((hourglass - turn * before).norm() < 1e-4);
  }
}

TEST_CASE("internal forces balance in force and moment, and their power is that of the stress",
          "[core][hex8]") {
  const HexVectors x = distorted_cubes();
  HexVectors to = distorted_cubes(0.1501);
  HexState<ElasticLaw> state;
  HexParameters damped = undamped;
  damped.hourglass_viscosity = 0.03;
  damped.linear_bulk_viscosity = 0.06;
  damped.quadratic_bulk_viscosity = 1.2;
  const HexStep step = advance_hex8(elastic, damped, between(x, to, 1e-6), state);
  for (int lane = 0; lane < n_lanes; ++lane) {
    const Nodes force = lane_of(step.force, lane), place = lane_of(to, lane);
    const double size = force.norm();
    REQUIRE(size > 0.0);
    CHECK(force.rowwise().sum().norm() < 1e-12 * size);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (int node = 0; node < 8; ++node)
      moment += Eigen::Vector3d(place.col(node)).cross(Eigen::Vector3d(force.col(node)));
    CHECK(moment.norm() < 1e-12 * size);
  }
}

TEST_CASE("an hourglass motion is resisted, and a linear one is not taken for it", "[core][hex8]") {
  const HexVectors x = distorted_cubes();
  HexVectors bent = x;
  for (std::size_t node = 0; node < 8; ++node) bent[0][node] += 1e-6 * natural[node][1] * natural[node][2];
  HexState<ElasticLaw> state;
  const HexStep step = advance_hex8(elastic, undamped, between(x, bent, 1e-6), state);
  CHECK((step.hourglass_work > 0.0).all());
  Lanes power = Lanes::Zero();
  for (std::size_t node = 0; node < 8; ++node)
    power += step.force[0][node] * natural[node][1] * natural[node][2];
  CHECK((power > 0.0).all());
}

TEST_CASE("the stable step is below that of the element's highest frequency, and near it for a cube",
          "[core][hex8]") {
  const double distortion = GENERATE(0.0, 0.15);
  const HexVectors x = distorted_cubes(distortion);
  constexpr double h = 1e-9;
  HexState<ElasticLaw> rest;
  const HexStep step = advance_hex8(elastic, undamped, between(x, x, 1.0), rest);
  std::array<Eigen::Matrix<double, 24, 24>, n_lanes> stiffness;
  for (std::size_t column = 0; column < 24; ++column) {
    HexVectors moved = x;
    moved[column % 3][column / 3] += h;
    HexState<ElasticLaw> state;
    const HexStep response = advance_hex8(elastic, undamped, between(x, moved, 1.0), state);
    for (int lane = 0; lane < n_lanes; ++lane) {
      stiffness[static_cast<std::size_t>(lane)].col(static_cast<Eigen::Index>(column)) =
          Eigen::Map<const Eigen::Matrix<double, 24, 1>>(lane_of(response.force, lane).data()) / h;
    }
  }
  for (int lane = 0; lane < n_lanes; ++lane) {
    const auto& k = stiffness[static_cast<std::size_t>(lane)];
    const Eigen::Matrix<double, 24, 24> symmetric = 0.5 * (k + k.transpose());
    CHECK((k - k.transpose()).norm() < 1e-5 * k.norm());
    const double greatest =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 24, 24>>(symmetric).eigenvalues()(23);
    const double limit = 2.0 / std::sqrt(greatest / (7800.0 / 8.0));
    CHECK(step.stable_step(lane) <= limit * (1.0 + 1e-6));
    CHECK(step.stable_step(lane) >= (distortion == 0.0 ? 0.97 : 0.8) * limit);
  }
}

TEST_CASE("bulk viscosity resists and shortens the stable step", "[core][hex8]") {
  const HexVectors x = distorted_cubes();
  const HexVectors closed = mapped(x, Eigen::Matrix3d::Identity() * 0.999);
  HexState<ElasticLaw> with, without;
  HexParameters damped = undamped;
  damped.linear_bulk_viscosity = 0.06;
  damped.quadratic_bulk_viscosity = 1.2;
  const HexStep slow = advance_hex8(elastic, damped, between(x, closed, 1e-6), with);
  const HexStep fast = advance_hex8(elastic, undamped, between(x, closed, 1e-6), without);
  CHECK((slow.stable_step < fast.stable_step).all());
  CHECK((slow.viscous_work > 0.0).all());
  CHECK((fast.viscous_work == 0.0).all());
  // Nodes on the far side are pushed outwards more.
  CHECK((slow.force[0][1] < fast.force[0][1]).all());
}
