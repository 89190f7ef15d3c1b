// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/gmres.hpp"

#include <Eigen/LU>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Equations with an unsymmetric matrix that is stiffer from one unknown to the next.
struct Equations {
  explicit Equations(Eigen::Index n)
      : matrix(Eigen::MatrixXd::Random(n, n)), right(Eigen::VectorXd::Random(n)) {
    matrix.diagonal() += Eigen::VectorXd::LinSpaced(n, 5.0, 500.0);
  }
  LinearSearch solve(double tolerance, int max_iterations, int cycle, Eigen::VectorXd& solution) const {
    return gmres(
        [&](const Eigen::VectorXd& direction, Eigen::VectorXd& product) { product = matrix * direction; },
        [&](const Eigen::VectorXd& left, Eigen::VectorXd& step) {
          step = left.cwiseQuotient(matrix.diagonal());
        },
        right, tolerance, max_iterations, solution, cycle);
  }
  double left(const Eigen::VectorXd& solution) const {
    return (right - matrix * solution).norm() / right.norm();
  }

  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

}  // namespace

TEST_CASE("minimal residuals solve unsymmetric equations, with and without beginning anew",
          "[core][statics]") {
  const Equations equations(30);
  const int cycle = GENERATE(60, 4);
  Eigen::VectorXd solution;
  const LinearSearch search = equations.solve(1e-9, 200, cycle, solution);
  CHECK(search.end == LinearSearch::End::converged);
  CHECK(search.n_iterations > 4);
  CHECK(equations.left(solution) < 2e-9);
  CHECK((solution - equations.matrix.lu().solve(equations.right)).norm() < 1e-7 * solution.norm());
}

TEST_CASE("minimal residuals leave less by each iteration, and tell when these are too few",
          "[core][statics]") {
  const Equations equations(30);
  Eigen::VectorXd solution;
  double last = 1.0;
  for (int n = 1; n < 6; ++n) {
    const LinearSearch search = equations.solve(1e-12, n, 60, solution);
    CHECK(search.end == LinearSearch::End::exhausted);
    CHECK(search.n_iterations == n);
    CHECK(equations.left(solution) < last);
    last = equations.left(solution);
  }
}

TEST_CASE("minimal residuals of no right side are none", "[core][statics]") {
  Equations equations(3);
  equations.right.setZero();
  Eigen::VectorXd solution;
  CHECK(equations.solve(1e-3, 10, 60, solution).n_iterations == 0);
  CHECK(solution.isZero(0.0));
}
