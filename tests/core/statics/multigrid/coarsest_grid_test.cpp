// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/coarsest_grid.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A turned frame of n directions.
Eigen::MatrixXd turned_frame(Eigen::Index n) {
  Eigen::MatrixXd some(n, n);
  for (Eigen::Index i = 0; i < some.size(); ++i) some(i) = std::sin(1.7 * static_cast<double>(i * i));
  return Eigen::HouseholderQR<Eigen::MatrixXd>(some).householderQ();
}

}  // namespace

TEST_CASE("the coarsest equations are solved", "[core][statics]") {
  const Eigen::MatrixXd frame = turned_frame(6);
  const Eigen::MatrixXd matrix =
      frame * Eigen::VectorXd::LinSpaced(6, 1.0, 1e6).asDiagonal() * frame.transpose();
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(6, -1.0, 2.0);
  CHECK((CoarsestGrid(matrix).solve(matrix * wanted) - wanted).norm() < 1e-8);
  CHECK(CoarsestGrid(Eigen::MatrixXd::Constant(1, 1, 4.0)).solve(Eigen::VectorXd::Constant(1, 2.0))(0) ==
        0.5);
}

TEST_CASE("directions without stiffness are left out", "[core][statics]") {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
  matrix.topLeftCorner<2, 2>() << 2, -2, -2, 2;  // a spring between two that nothing holds
  matrix(2, 2) = 8.0;
  const CoarsestGrid grid(matrix);
  const Eigen::VectorXd x = grid.solve((Eigen::VectorXd(4) << 2, -2, 4, 3).finished());
  CHECK((matrix * x - Eigen::Vector4d(2, -2, 4, 0)).norm() < 1e-14);
  CHECK(x(3) == 0.0);
  CHECK(x.allFinite());
}

TEST_CASE("directions of a negative stiffness move as if it were positive", "[core][statics]") {
  const Eigen::MatrixXd matrix = Eigen::Vector3d(2, -4, 5).asDiagonal();
  CHECK(CoarsestGrid(matrix).solve(Eigen::Vector3d(2, 2, 10)).isApprox(Eigen::Vector3d(1, 0.5, 2)));
  const Eigen::MatrixXd frame = turned_frame(5);
  const Eigen::MatrixXd turned =
      frame * (Eigen::VectorXd(5) << 3, -1, 2, -7, 5).finished().asDiagonal() * frame.transpose();
  const CoarsestGrid grid(turned);
  for (Eigen::Index i = 0; i < 5; ++i) {
    const Eigen::VectorXd force = Eigen::VectorXd::Unit(5, i);
    CHECK(force.dot(grid.solve(force)) > 0.0);
  }
}
