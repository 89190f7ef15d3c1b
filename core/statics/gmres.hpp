// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace contactsim {

/// How a search for the solution of linear equations ended.
struct LinearSearch {
  enum class End : std::uint8_t { converged, exhausted };
  End end = End::converged;
  std::int64_t n_iterations = 0;
};

/// Solves equations with any matrix by generalised minimal residuals, preconditioned from the right: what it
/// ends with leaves no more of the right side than any fewer iterations. Every `cycle` iterations it begins
/// anew with what is left, since each keeps a vector.
///   multiply(direction, product), precondition(residual, step)  set the latter; both are linear
///   tolerance  of the size of the right side [1]
/// Source: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856-869; Saad, Iterative Methods for Sparse
/// Linear Systems, 2nd ed. (2003), algorithm 9.5.
template <class Multiply, class Precondition>
LinearSearch gmres(const Multiply& multiply, const Precondition& precondition, const Eigen::VectorXd& right,
                   double tolerance, int max_iterations, Eigen::VectorXd& solution, int cycle = 60) {
  LinearSearch search;
  solution.setZero(right.size());
  const double target = tolerance * right.norm();
  Eigen::VectorXd left = right, step, product;
  double size = left.norm();
  while (size > target) {
    if (search.n_iterations >= max_iterations) {
      search.end = LinearSearch::End::exhausted;
      break;
    }
    const auto most =
        static_cast<Eigen::Index>(std::min<std::int64_t>(cycle, max_iterations - search.n_iterations));
    std::vector<Eigen::VectorXd> basis{left / size};
    // Of the least squares problem: its matrix, made triangular column by column, and its right side.
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(most + 1, most);
    Eigen::VectorXd of_basis = Eigen::VectorXd::Zero(most + 1);
    std::vector<Eigen::JacobiRotation<double>> rotations;
    of_basis(0) = size;
    Eigen::Index n = 0;
    for (bool is_all = false; n < most && std::abs(of_basis(n)) > target && !is_all; ++n) {
      precondition(basis.back(), step);
      multiply(step, product);
      auto column = triangle.col(n);
      for (Eigen::Index i = 0; i <= n; ++i) {
        const Eigen::VectorXd& known = basis[static_cast<std::size_t>(i)];
        column(i) = known.dot(product);
        product -= column(i) * known;
      }
      column(n + 1) = product.norm();
      is_all = !(column(n + 1) > 0.0);
      if (!is_all) basis.push_back(product / column(n + 1));
      for (Eigen::Index i = 0; i < n; ++i)
        column.applyOnTheLeft(i, i + 1, rotations[static_cast<std::size_t>(i)].adjoint());
      auto& rotation = rotations.emplace_back();
      rotation.makeGivens(column(n), column(n + 1));
      column.applyOnTheLeft(n, n + 1, rotation.adjoint());
      of_basis.applyOnTheLeft(n, n + 1, rotation.adjoint());
    }
    search.n_iterations += n;
    const Eigen::VectorXd shares =
        triangle.topLeftCorner(n, n).template triangularView<Eigen::Upper>().solve(of_basis.head(n));
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(right.size());
    for (Eigen::Index i = 0; i < n; ++i) sum += shares(i) * basis[static_cast<std::size_t>(i)];
    precondition(sum, step);
    solution += step;
    size = std::abs(of_basis(n));
    if (!(size > target) || search.n_iterations >= max_iterations) continue;
    multiply(solution, product);
    left = right - product;
    size = left.norm();
  }
  return search;
}

}  // namespace contactsim
