// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/coarsest_grid.hpp"

#include <cmath>

namespace contactsim {

CoarsestGrid::CoarsestGrid(const Eigen::MatrixXd& matrix) : factor_(matrix), inverses_(factor_.vectorD()) {
  constexpr double nothing = 1e-12;  // of the largest pivot
  const double largest = inverses_.cwiseAbs().maxCoeff();
  for (double& pivot : inverses_) pivot = std::abs(pivot) > nothing * largest ? 1.0 / std::abs(pivot) : 0.0;
}

Eigen::VectorXd CoarsestGrid::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd x = factor_.transpositionsP() * right;
  factor_.matrixL().solveInPlace(x);
  x = inverses_.cwiseProduct(x).eval();
  factor_.matrixU().solveInPlace(x);
  return factor_.transpositionsP().transpose() * x;
}

}  // namespace contactsim
