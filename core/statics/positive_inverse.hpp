// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace contactsim {

/// The inverse of the symmetric part of a stiffness, in which directions without any have an inverse of 0,
/// and those of a negative one that of its size: what gives way is still to be moved.
template <int N>
Eigen::Matrix<double, N, N> positive_inverse(const Eigen::Matrix<double, N, N>& stiffness) {
  using Square = Eigen::Matrix<double, N, N>;
  constexpr double nothing = 1e-9;  // of the largest
  const Eigen::SelfAdjointEigenSolver<Square> solver(0.5 * (stiffness + stiffness.transpose()));
  const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
  Eigen::Matrix<double, N, 1> inverse(solver.eigenvalues());
  for (Eigen::Index i = 0; i < inverse.size(); ++i) {
    const double value = std::abs(solver.eigenvalues()(i));
    inverse(i) = value > nothing * largest ? 1.0 / value : 0.0;
  }
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace contactsim
