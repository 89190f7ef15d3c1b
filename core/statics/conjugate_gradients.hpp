// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace contactsim {

/// How linear conjugate gradients ended.
struct LinearSearch {
  enum class End : std::uint8_t { converged, exhausted, negative };
  End end = End::converged;
  std::int64_t n_iterations = 0;
};

/// Solves equations with a symmetric matrix by preconditioned conjugate gradients. At a direction of negative
/// or no stiffness it ends with what it has found before, the first time with that direction.
///   multiply(direction, product), precondition(residual, step)  set the latter
///   tolerance  of the size of the right side [1]
/// Source: Nocedal and Wright, Numerical Optimization, 2nd ed. (2006), algorithm 5.3.
template <class Multiply, class Precondition>
LinearSearch conjugate_gradients(const Multiply& multiply, const Precondition& precondition,
                                 const Eigen::VectorXd& right, double tolerance, int max_iterations,
                                 Eigen::VectorXd& solution) {
  LinearSearch search;
  Eigen::VectorXd left = right, product, step;
  const double target = tolerance * right.norm();
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(right.size());
  double last = 1.0;  // step . left
  solution.setZero(right.size());
  for (int i = 0; left.norm() > target; ++i) {
    if (i == max_iterations) {
      search.end = LinearSearch::End::exhausted;
      break;
    }
    precondition(left, step);
    const double now = step.dot(left);
    direction = step + (i == 0 ? 0.0 : now / last) * direction;
    last = now;
    multiply(direction, product);
    const double curvature = direction.dot(product);
    if (!(curvature > 0.0) || !(now > 0.0)) {
      search.end = curvature < 0.0 ? LinearSearch::End::negative : LinearSearch::End::exhausted;
      if (i == 0) solution = direction;
      break;
    }
    ++search.n_iterations;
    const double way = now / curvature;
    solution += way * direction;
    left -= way * product;
  }
  return search;
}

}  // namespace contactsim
