// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <vector>

#include "core/statics/conjugate_gradients.hpp"

namespace contactsim {

/// Solves equations with any matrix by generalised minimal residuals without restarts, preconditioned from the
/// right: what it ends with leaves no more of the right side than any fewer iterations.
///   multiply(direction, product), precondition(residual, step)  set the latter; both are linear
///   tolerance  of the size of the right side [1]
/// Source: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856-869; Saad, Iterative Methods for Sparse Linear
/// Systems, 2nd ed. (2003), algorithm 9.5.
template <class Multiply, class Precondition>
LinearSearch gmres(const Multiply& multiply, const Precondition& precondition, const Eigen::VectorXd& right,
                   double tolerance, int max_iterations, Eigen::VectorXd& solution) {
  LinearSearch search;
  solution.setZero(right.size());
  const double size = right.norm();
  if (!(size > 0.0)) return search;
  std::vector<Eigen::VectorXd> basis{right / size};
  // Of the least squares problem: its matrix, made triangular column by column, and its right side.
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
  Eigen::VectorXd left = Eigen::VectorXd::Zero(max_iterations + 1);
  std::vector<Eigen::JacobiRotation<double>> rotations;
  left(0) = size;
  Eigen::VectorXd step, product;
  Eigen::Index n = 0;
  while (std::abs(left(n)) > tolerance * size) {
    if (n == max_iterations) {
      search.end = LinearSearch::End::exhausted;
      break;
    }
    precondition(basis.back(), step);
    multiply(step, product);
    auto column = triangle.col(n);
    for (Eigen::Index i = 0; i <= n; ++i) {
      const Eigen::VectorXd& known = basis[static_cast<std::size_t>(i)];
      column(i) = known.dot(product);
      product -= column(i) * known;
    }
    column(n + 1) = product.norm();
    const bool is_all = !(column(n + 1) > 0.0);
    if (!is_all) basis.push_back(product / column(n + 1));
    for (Eigen::Index i = 0; i < n; ++i)
      column.applyOnTheLeft(i, i + 1, rotations[static_cast<std::size_t>(i)].adjoint());
    auto& rotation = rotations.emplace_back();
    rotation.makeGivens(column(n), column(n + 1));
    column.applyOnTheLeft(n, n + 1, rotation.adjoint());
    left.applyOnTheLeft(n, n + 1, rotation.adjoint());
    ++n;
    if (is_all) break;
  }
  search.n_iterations = n;
  if (n == 0) return search;
  const Eigen::VectorXd shares =
      triangle.topLeftCorner(n, n).template triangularView<Eigen::Upper>().solve(left.head(n));
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(right.size());
  for (Eigen::Index i = 0; i < n; ++i) sum += shares(i) * basis[static_cast<std::size_t>(i)];
  precondition(sum, solution);
  return search;
}

}  // namespace contactsim
