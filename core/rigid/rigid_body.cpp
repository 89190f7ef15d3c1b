// SPDX-License-Identifier: BSD-3-Clause
#include "core/rigid/rigid_body.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace contactsim {

namespace {

/// Calls next(turning) until it stays.
template <class Next>
Eigen::Vector3d settle(Eigen::Vector3d turning, const Next& next) {
  constexpr int max_iterations = 100;  // each one gains a factor of the angle of a step
  constexpr double tolerance = 1e-15;
  for (int i = 0; i < max_iterations; ++i) {
    const Eigen::Vector3d better = next(turning);
    const double change = (better - turning).norm();
    turning = better;
    if (change <= tolerance * turning.norm()) break;
  }
  return turning;
}

}  // namespace

Eigen::Matrix3d inverse_where_it_is(const Eigen::Matrix3d& symmetric) {
  constexpr double smallest = 1e-12;  // of the largest eigenvalue
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()(i);
    if (value > smallest * solver.eigenvalues().maxCoeff()) inverse(i) = 1.0 / value;
  }
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

Eigen::Quaterniond turn_by(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  // sin(angle / 2) / angle, where the angle may vanish.
  const double sine = angle > 1e-4 ? std::sin(0.5 * angle) / angle : 0.5 - angle * angle / 48.0;
  Eigen::Quaterniond turn;
  turn.w() = std::cos(0.5 * angle);
  turn.vec() = sine * vector;
  return turn;
}

Eigen::Matrix3d inertia_amid(const RigidBody& body, const Eigen::Quaterniond& orientation,
                             const Eigen::Vector3d& turning, double dt) {
  const Eigen::Matrix3d amid = (turn_by(0.5 * dt * turning) * orientation).toRotationMatrix();
  return amid * body.inertia * amid.transpose();
}

Eigen::Vector3d turning_of(const RigidBody& body, const Eigen::Quaterniond& orientation,
                           const Eigen::Vector3d& spin, double dt) {
  const auto next = [&](const Eigen::Vector3d& turning) -> Eigen::Vector3d {
    const Eigen::Matrix3d amid = (turn_by(0.5 * dt * turning) * orientation).toRotationMatrix();
    return amid * (body.flexible * (amid.transpose() * spin));
  };
  return settle(next(Eigen::Vector3d::Zero()), next);
}

Eigen::Vector3d turning_of(const RigidBody& body, const RigidBodyState& state, const Eigen::Vector3d& spin,
                           double dt, const Eigen::Vector3d& given, const Eigen::Matrix3d& free) {
  const auto next = [&](const Eigen::Vector3d& turning) -> Eigen::Vector3d {
    const Eigen::Matrix3d inertia = inertia_amid(body, state.orientation, turning, dt);
    const Eigen::Matrix3d free_inertia = free * inertia * free;
    const Eigen::Vector3d left = free * (spin - inertia * given);
    return given + free * inverse_where_it_is(free_inertia) * left;
  };
  return settle(next(given), next);
}

}  // namespace contactsim
