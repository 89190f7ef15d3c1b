// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/strain_measures.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace contactsim {

namespace {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

// The tensor with the same axes whose principal values are f of those of a symmetric one.
template <class Function>
Eigen::Matrix3d apply(const Eigen::Matrix3d& a, Function f) {
  const Solver solver(a);
  const Eigen::Vector3d values = solver.eigenvalues().unaryExpr(f);
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

Eigen::Vector3d principal_values(const Eigen::Matrix3d& a) {
  return Solver(a, Eigen::EigenvaluesOnly).eigenvalues().reverse();
}

Eigen::Matrix3d log_strain(const Eigen::Matrix3d& f) {
  return apply(f * f.transpose(), [](double value) { return 0.5 * std::log(value); });
}

Eigen::Matrix3d green_lagrange_strain(const Eigen::Matrix3d& f) {
  return 0.5 * (f.transpose() * f - Eigen::Matrix3d::Identity());
}

Eigen::Matrix3d rotation_of(const Eigen::Matrix3d& f) {
  return f * apply(f.transpose() * f, [](double value) { return 1.0 / std::sqrt(value); });
}

Eigen::Matrix3d deviator(const Eigen::Matrix3d& a) {
  return a - a.trace() / 3.0 * Eigen::Matrix3d::Identity();
}

double von_mises_stress(const Eigen::Matrix3d& stress) { return std::sqrt(1.5) * deviator(stress).norm(); }

double effective_strain(const Eigen::Matrix3d& strain) {
  return std::sqrt(2.0 / 3.0) * deviator(strain).norm();
}

Eigen::Matrix3d symmetric(std::span<const double, 6> c) {
  Eigen::Matrix3d a;
  a << c[0], c[3], c[5], c[3], c[1], c[4], c[5], c[4], c[2];
  return a;
}

std::array<double, 6> components_of_symmetric(const Eigen::Matrix3d& a) {
  return {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(1, 2), a(2, 0)};
}

std::array<double, 9> components_of(const Eigen::Matrix3d& a) {
  return {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(1, 2), a(2, 0), a(1, 0), a(2, 1), a(0, 2)};
}

}  // namespace contactsim
