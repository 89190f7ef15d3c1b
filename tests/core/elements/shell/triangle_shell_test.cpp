// SPDX-License-Identifier: BSD-3-Clause
// The kernel of three-node shells by itself: frame, rates, forces, what bounds its frequencies.
#include "core/elements/shell/triangle_shell.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

NodeVectors<3> triangle_lanes(const Matrix3d& nodes) {
  NodeVectors<3> lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < 3; ++a)
      lanes[i][a].setConstant(nodes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(a)));
  }
  return lanes;
}

Matrix3d triangle_frame(const TriangleShell& shell) {
  Matrix3d frame;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      frame(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = shell.frame()[i][j](0);
  }
  return frame;
}

/// All rates in a row: membrane, curvature, shear, hourglass.
Eigen::Matrix<double, 9, 1> triangle_row(const TriangleShell::Rates& rates) {
  Eigen::Matrix<double, 9, 1> row;
  Eigen::Index n = 0;
  for (const Lanes& rate : rates.membrane) row[n++] = rate(0);
  for (const Lanes& rate : rates.curvature) row[n++] = rate(0);
  for (const Lanes& rate : rates.shear) row[n++] = rate(0);
  for (const Lanes& rate : rates.hourglass) row[n++] = rate(0);
  return row;
}

/// A triangle of edges 3, 2.06, 2.5, turned in space.
Matrix3d some_triangle() {
  Matrix3d x;
  x << 0, 3, 0.5, 0, 0, 2, 0, 0, 0;
  return Matrix3d(Eigen::AngleAxisd(0.9, Vector3d(1, 2, -1).normalized())) * x;
}

Matrix3d random_triangle_motion(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  return Matrix3d::NullaryExpr([&] { return one(random); });
}

const Matrix3d at_rest = Matrix3d::Zero();

}  // namespace

TEST_CASE("the x axis of a triangle lies along its first edge, gradients are those of linear functions",
          "[core][shells]") {
  const Matrix3d x = some_triangle();
  const TriangleShell shell(triangle_lanes(x));
  const Matrix3d frame = triangle_frame(shell);
  CHECK((frame.row(0).transpose() - (x.col(1) - x.col(0)).normalized()).norm() < 1e-14);
  CHECK((frame.row(2).transpose() -
         Vector3d(x.col(1) - x.col(0)).cross(Vector3d(x.col(2) - x.col(0))).normalized())
            .norm() < 1e-14);
  CHECK(frame.determinant() == Approx(1.0));
  CHECK(shell.area()(0) == Approx(3.0));
  const auto gradients = shell.gradients();
  const Matrix3d local = frame * x;
  for (std::size_t i = 0; i < 2; ++i) {
    double sum = 0.0;
    for (std::size_t a = 0; a < 3; ++a) sum += gradients[i][a](0);
    CHECK(std::abs(sum) < 1e-15);
    for (Eigen::Index j = 0; j < 2; ++j) {  // of x and y themselves
      double slope = 0.0;
      for (std::size_t a = 0; a < 3; ++a)
        slope += gradients[i][a](0) * local(j, static_cast<Eigen::Index>(a));
      CHECK(slope == Approx(static_cast<Eigen::Index>(i) == j ? 1.0 : 0.0).margin(1e-14));
    }
  }
}

TEST_CASE("a rigid motion of a triangle has no rates", "[core][shells]") {
  const Matrix3d x = some_triangle();
  const TriangleShell shell(triangle_lanes(x));
  const Vector3d turning(0.3, -0.7, 0.5), velocity(1, 2, 3);
  Matrix3d v, w;
  for (Eigen::Index a = 0; a < 3; ++a) {
    v.col(a) = velocity + turning.cross(x.col(a));
    w.col(a) = turning;
  }
  CHECK(triangle_row(shell.rates(triangle_lanes(v), triangle_lanes(w))).norm() < 1e-13);
  w = triangle_frame(shell).row(2).transpose() * Eigen::RowVector3d(1, -2, 3);  // fibres about themselves
  CHECK(triangle_row(shell.rates(triangle_lanes(at_rest), triangle_lanes(w))).norm() < 1e-13);
}

TEST_CASE("a triangle has the rates of a uniform gradient and of a uniform curvature, without shear",
          "[core][shells]") {
  const Matrix3d x = some_triangle();
  const TriangleShell shell(triangle_lanes(x));
  const Matrix3d frame = triangle_frame(shell), local = frame * x;
  Matrix3d gradient;
  gradient << 0.2, 0.3, 0, -0.1, 0.5, 0, 0.4, -0.6, 0;
  auto rates = triangle_row(
      shell.rates(triangle_lanes(frame.transpose() * gradient * local), triangle_lanes(at_rest)));
  Eigen::Matrix<double, 9, 1> expected = Eigen::Matrix<double, 9, 1>::Zero();
  expected.head<8>() << 0.2, 0.5, 0.2, 0, 0, 0, 0.4, -0.6;
  CHECK((rates - expected).norm() < 1e-13);
  // u_z = x.K x / 2 with fibres that follow the slope: psi = -K x, w = (-psi_y, psi_x).
  const Eigen::Matrix2d k{{0.7, 0.2}, {0.2, -0.4}};
  Matrix3d v = Matrix3d::Zero(), w = Matrix3d::Zero();
  for (Eigen::Index a = 0; a < 3; ++a) {
    const Eigen::Vector2d at = local.col(a).head<2>(), slope = k * at;
    v(2, a) = 0.5 * at.dot(slope);
    w.col(a) << slope.y(), -slope.x(), 0.0;
  }
  rates =
      triangle_row(shell.rates(triangle_lanes(frame.transpose() * v), triangle_lanes(frame.transpose() * w)));
  expected.setZero();
  expected.segment<3>(3) << -0.7, 0.4, -0.4;
  CHECK((rates - expected).norm() < 1e-13);
}

TEST_CASE("forces and moments of a triangle have minus the power of what resists the rates",
          "[core][shells]") {
  const TriangleShell shell(triangle_lanes(some_triangle()));
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Matrix3d v = random_triangle_motion(seed), w = random_triangle_motion(seed + 100);
    TriangleShell::Rates resistance;
    std::mt19937 random(seed);
    const auto set = [&](auto& lanes) {
      for (Lanes& one : lanes) one.setConstant(std::uniform_real_distribution<double>(-1.0, 1.0)(random));
    };
    set(resistance.membrane);
    set(resistance.curvature);
    set(resistance.shear);
    set(resistance.hourglass);
    NodeVectors<3> force, moment;
    shell.set_forces(resistance, force, moment);
    double power = 0.0;
    Vector3d net = Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < 3; ++a) {
        const auto row = static_cast<Eigen::Index>(i), node = static_cast<Eigen::Index>(a);
        power += force[i][a](0) * v(row, node) + moment[i][a](0) * w(row, node);
        net[row] += force[i][a](0);
      }
    }
    CHECK(net.norm() < 1e-13);
    CHECK(
        power ==
        Approx(-triangle_row(resistance).dot(triangle_row(shell.rates(triangle_lanes(v), triangle_lanes(w)))))
            .margin(1e-13));
  }
}

TEST_CASE("bounds of a triangle are the norms of the rows of its rates", "[core][shells]") {
  const TriangleShell shell(triangle_lanes(some_triangle()));
  Eigen::Matrix<double, 9, 9> by_moving, by_turning;
  for (Eigen::Index k = 0; k < 9; ++k) {
    Matrix3d unit = Matrix3d::Zero();
    unit(k % 3, k / 3) = 1.0;
    by_moving.col(k) = triangle_row(shell.rates(triangle_lanes(unit), triangle_lanes(at_rest)));
    by_turning.col(k) = triangle_row(shell.rates(triangle_lanes(at_rest), triangle_lanes(unit)));
  }
  const ShellSizes sizes = shell.sizes();
  CHECK(sizes.gram_trace()(0) == Approx(by_moving.middleRows<2>(6).squaredNorm()));
  const Eigen::Matrix2d gram = by_moving.middleRows<2>(6) * by_moving.middleRows<2>(6).transpose();
  CHECK(sizes.gram_eigenvalue()(0) ==
        Approx(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(gram).eigenvalues().maxCoeff()));
  const Eigen::Matrix2d turning = by_turning.middleRows<2>(6) * by_turning.middleRows<2>(6).transpose();
  CHECK(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(turning).eigenvalues().maxCoeff() <=
        1.0000001 * sizes.shear_by_turning(0));
  const auto modes = shell.hourglass_sizes();
  CHECK(by_moving.row(8).norm() < 1e-14);
  CHECK(modes[0].by_moving(0) == 0.0);
  CHECK(modes[0].by_turning(0) == Approx(by_turning.row(8).squaredNorm()));
}
