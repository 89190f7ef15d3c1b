// SPDX-License-Identifier: BSD-3-Clause
// The kernel of four-node shells by itself: frame, rates, forces, what bounds its frequencies.
#include "core/elements/shell/quad_shell.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

using QuadNodes = Eigen::Matrix<double, 3, 4>;

NodeVectors<4> in_lanes(const QuadNodes& nodes) {
  NodeVectors<4> lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < 4; ++a)
      lanes[i][a].setConstant(nodes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(a)));
  }
  return lanes;
}

Matrix3d frame_of(const QuadShell& shell) {
  Matrix3d frame;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      frame(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = shell.frame()[i][j](0);
  }
  return frame;
}

/// All rates in a row: membrane, curvature, shear, hourglass.
Eigen::Matrix<double, 14, 1> in_row(const QuadShell::Rates& rates) {
  Eigen::Matrix<double, 14, 1> row;
  Eigen::Index n = 0;
  for (const Lanes& rate : rates.membrane) row[n++] = rate(0);
  for (const Lanes& rate : rates.curvature) row[n++] = rate(0);
  for (const Lanes& rate : rates.shear) row[n++] = rate(0);
  for (const Lanes& rate : rates.hourglass) row[n++] = rate(0);
  return row;
}

/// A quadrilateral 3 long and 2 wide, distorted in its plane, warped by so much up and down in turn, turned.
QuadNodes some_quad(double warp, double distortion = 0.2) {
  QuadNodes x;
  x << 0, 3, 3 + distortion, -0.5 * distortion, 0, distortion, 2, 2 - distortion, warp, -warp, warp, -warp;
  return Matrix3d(Eigen::AngleAxisd(0.9, Vector3d(1, 2, -1).normalized())) * x;
}

QuadNodes random_nodes(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  return QuadNodes::NullaryExpr([&] { return one(random); });
}

const QuadNodes no_motion = QuadNodes::Zero();

}  // namespace

TEST_CASE("the frame of a rectangle lies along its edges, its area is theirs", "[core][shells]") {
  QuadNodes x;
  x << 0, 3, 3, 0, 0, 0, 2, 2, 1, 1, 1, 1;
  const QuadShell shell(in_lanes(x));
  CHECK((frame_of(shell) - Matrix3d::Identity()).norm() < 1e-14);
  CHECK(shell.area()(0) == Approx(6.0));
  const auto gradients = shell.gradients();
  // The shape functions fall by half over 3 along x, over 2 along y, in the middle.
  const double along_x[] = {-1, 1, 1, -1}, along_y[] = {-1, -1, 1, 1};
  for (std::size_t a = 0; a < 4; ++a) {
    CHECK(gradients[0][a](0) == Approx(along_x[a] / 6.0));
    CHECK(gradients[1][a](0) == Approx(along_y[a] / 4.0));
  }
}

TEST_CASE("whichever node comes first, the frame lies the same way but for right angles", "[core][shells]") {
  const QuadNodes x = some_quad(0.3);
  const Matrix3d first = frame_of(QuadShell(in_lanes(x)));
  CHECK((first * first.transpose() - Matrix3d::Identity()).norm() < 1e-13);
  CHECK(first.determinant() == Approx(1.0));
  QuadNodes turned;
  turned << x.col(1), x.col(2), x.col(3), x.col(0);
  const Matrix3d second = frame_of(QuadShell(in_lanes(turned)));
  CHECK((second.row(0) - first.row(1)).norm() < 1e-13);
  CHECK((second.row(1) + first.row(0)).norm() < 1e-13);
  CHECK((second.row(2) - first.row(2)).norm() < 1e-13);
}

TEST_CASE("a rigid motion of a warped shell has no rates, and turning fibres about themselves none either",
          "[core][shells]") {
  const double warp = GENERATE(0.0, 0.4);
  const QuadNodes x = some_quad(warp);
  const QuadShell shell(in_lanes(x));
  const Vector3d turning(0.3, -0.7, 0.5), velocity(1, 2, 3);
  QuadNodes v, w;
  for (Eigen::Index a = 0; a < 4; ++a) {
    v.col(a) = velocity + turning.cross(x.col(a));
    w.col(a) = turning;
  }
  CHECK(in_row(shell.rates(in_lanes(v), in_lanes(w))).norm() < 1e-13);
  if (warp > 0.0) return;
  w = frame_of(shell).row(2).transpose() * Eigen::RowVector4d(1, -2, 3, 5);
  CHECK(in_row(shell.rates(in_lanes(no_motion), in_lanes(w))).norm() < 1e-13);
}

TEST_CASE("rates of a flat shell are those of a uniform gradient, and of each hourglass mode alone",
          "[core][shells]") {
  const double distortion = GENERATE(0.0, 0.2);
  const QuadNodes x = some_quad(0.0, distortion);
  const QuadShell shell(in_lanes(x));
  const Matrix3d frame = frame_of(shell);
  const auto rates_of = [&](const QuadNodes& local) {
    return in_row(shell.rates(in_lanes(frame.transpose() * local), in_lanes(no_motion)));
  };
  Matrix3d gradient;
  gradient << 0.2, 0.3, 0, -0.1, 0.5, 0, 0, 0, 0;
  Eigen::Matrix<double, 14, 1> expected = Eigen::Matrix<double, 14, 1>::Zero();
  expected.head<3>() << 0.2, 0.5, 0.2;
  CHECK((rates_of(gradient * (frame * x)) - expected).norm() < 1e-13);
  // A slope is shear, of a rectangle nothing else; edges that are not parallel see different parts of it.
  gradient.setZero();
  gradient.row(2) << 0.4, -0.6, 0;
  const auto of_slope = rates_of(gradient * (frame * x));
  CHECK(of_slope.head<6>().norm() < 1e-13);
  CHECK(of_slope[6] == Approx(0.4));
  CHECK(of_slope[7] == Approx(-0.6));
  CHECK((of_slope.tail<6>().norm() < 1e-13) == (distortion == 0.0));
  // Nodes that go to and fro in turn along x, along y: the sum of all, each with its sign.
  for (Eigen::Index i = 0; i < 2; ++i) {
    QuadNodes mode = QuadNodes::Zero();
    mode.row(i) << 1, -1, 1, -1;
    expected.setZero();
    expected[8 + i] = 4.0;
    CHECK((rates_of(mode) - expected).norm() < 1e-13);
  }
}

TEST_CASE("forces and moments have minus the power of what resists the rates", "[core][shells]") {
  const QuadNodes x = some_quad(GENERATE(0.0, 0.4));
  const QuadShell shell(in_lanes(x));
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const QuadNodes v = random_nodes(seed), w = random_nodes(seed + 100);
    QuadShell::Rates resistance;
    std::mt19937 random(seed);
    const auto set = [&](auto& lanes) {
      for (Lanes& one : lanes) one.setConstant(std::uniform_real_distribution<double>(-1.0, 1.0)(random));
    };
    set(resistance.membrane);
    set(resistance.curvature);
    set(resistance.shear);
    set(resistance.hourglass);
    NodeVectors<4> force, moment;
    shell.set_forces(resistance, force, moment);
    double power = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < 4; ++a)
        power += force[i][a](0) * v(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(a)) +
                 moment[i][a](0) * w(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(a));
    }
    CHECK(power ==
          Approx(-in_row(resistance).dot(in_row(shell.rates(in_lanes(v), in_lanes(w))))).margin(1e-13));
  }
}

TEST_CASE("bounds of a shell are no less than the rows of its rates", "[core][shells]") {
  const double warp = GENERATE(0.0, 0.3), distortion = GENERATE(0.0, 0.6);
  const QuadShell shell(in_lanes(some_quad(warp, distortion)));
  // Rows by unit velocities and angular velocities of the nodes, [rate][12].
  Eigen::Matrix<double, 14, 12> by_moving, by_turning;
  for (Eigen::Index k = 0; k < 12; ++k) {
    QuadNodes unit = QuadNodes::Zero();
    unit(k % 3, k / 3) = 1.0;
    by_moving.col(k) = in_row(shell.rates(in_lanes(unit), in_lanes(no_motion)));
    by_turning.col(k) = in_row(shell.rates(in_lanes(no_motion), in_lanes(unit)));
  }
  constexpr double round_off = 1.0 + 1e-12;
  const ShellSizes sizes = shell.sizes();
  const auto largest = [](const Eigen::MatrixXd& rows) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rows * rows.transpose()).eigenvalues().maxCoeff();
  };
  CHECK(largest(by_turning.middleRows<2>(6)) <= round_off * sizes.shear_by_turning(0));
  CHECK(largest(by_moving.middleRows<2>(6)) <= round_off * sizes.gram_eigenvalue()(0));
  CHECK(sizes.gram_trace()(0) == Approx(by_moving.middleRows<2>(6).squaredNorm()));
  const auto modes = shell.hourglass_sizes();
  // Both of a pair of membrane or bending modes lie at right angles: the first has the norm of either.
  const double moving = largest(by_moving.middleRows<2>(8)), turning = largest(by_turning.middleRows<2>(10));
  CHECK(moving <= round_off * modes[0].by_moving(0));
  CHECK(turning <= round_off * modes[2].by_turning(0));
  if (warp == 0.0) CHECK(moving == Approx(modes[0].by_moving(0)));
  if (warp == 0.0) CHECK(turning == Approx(modes[2].by_turning(0)));
  for (std::size_t k : {4, 5}) {
    const auto row = static_cast<Eigen::Index>(8 + k);
    CHECK(by_moving.row(row).squaredNorm() <= round_off * modes[k].by_moving(0));
    CHECK(by_turning.row(row).squaredNorm() <= round_off * 2.0 * modes[k].by_turning(0));
  }
}

TEST_CASE("the height of a warped shell is that of its nodes over the plane, in turn", "[core][shells]") {
  QuadNodes x;
  x << 0, 2, 2, 0, 0, 0, 2, 2, 0.1, -0.1, 0.1, -0.1;
  const QuadShell shell(in_lanes(x));
  CHECK(shell.warp().height(0) == Approx(0.4));  // the sum of all, each with its sign
  CHECK(shell.area()(0) == Approx(4.0));
  CHECK(shell.sizes().warp(0) == Approx(std::sqrt(2.0) * 0.1));  // z = 0.1 xi eta: z,xy = 0.1
  const double slope = 0.1 * std::sqrt(2.0);                     // at a node, where both are 0.1
  CHECK(slope * slope <= 1.0000001 * shell.sizes().tilt(0));
}
