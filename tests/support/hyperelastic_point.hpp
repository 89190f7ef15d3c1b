// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Dense>
#include <random>

#include "core/materials/strain_step.hpp"

namespace contactsim::test {

/// First Piola-Kirchhoff stress by differences of an energy, a function of the deformation gradient.
template <class Energy>
Eigen::Matrix3d piola(const Energy& energy, const Eigen::Matrix3d& f) {
  constexpr double h = 1e-5;
  Eigen::Matrix3d p;
  for (Eigen::Index i = 0; i < 9; ++i) {
    Eigen::Matrix3d more = f, less = f;
    more(i) += h;
    less(i) -= h;
    p(i) = (energy(more) - energy(less)) / (2.0 * h);
  }
  return p;
}

/// A material point in lane 0, with other lanes elsewhere, of a law whose stress follows from the
/// deformation.
template <class Law>
struct HyperelasticPoint {
  Law law;
  std::array<Lanes, Law::n_state> state;
  SymmetricLanes stress = SymmetricLanes::zero();
  LaneModuli moduli{};
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();

  explicit HyperelasticPoint(const Law& its_law) : law(its_law) { law.start(state); }

  void deform_to(const Eigen::Matrix3d& next) {
    const Eigen::Matrix3d gradient = (next - f) * (0.5 * (next + f)).inverse();
    StrainStep step{SymmetricLanes::zero(), {}, 1.0};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        step.gradient[i][j].setConstant(0.1 * (i == j));
        step.gradient[i][j](0) = gradient(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
    moduli = law.update(step, stress, state);
    f = next;
  }
  Eigen::Matrix3d cauchy() const {
    const auto& s = stress;
    return Eigen::Matrix3d{
        {s[0](0), s[3](0), s[5](0)}, {s[3](0), s[1](0), s[4](0)}, {s[5](0), s[4](0), s[2](0)}};
  }
};

inline Eigen::Matrix3d random_deformation(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  return Eigen::Matrix3d::Identity() + Eigen::Matrix3d::NullaryExpr([&] { return number(random); });
}

/// By how much the power of a velocity gradient of norm 1 on the rate of an energy's stress, per present
/// volume, exceeds the bound that moduli give, at most.
template <class Energy>
double excess_over(const LaneModuli& moduli, const Energy& energy, const Eigen::Matrix3d& f) {
  constexpr double h = 1e-4;
  Eigen::Matrix<double, 9, 9> power;
  for (Eigen::Index k = 0; k < 9; ++k) {
    Eigen::Matrix3d l = Eigen::Matrix3d::Zero();
    l(k) = 1.0;
    const Eigen::Matrix3d rate = (piola(energy, f + h * l * f) - piola(energy, f - h * l * f)) / (2.0 * h);
    const Eigen::Matrix3d spatial = rate * f.transpose() / f.determinant();
    power.col(k) = spatial.reshaped();
  }
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
  const Eigen::Matrix<double, 9, 1> one = unit.reshaped();
  const Eigen::Matrix<double, 9, 9> bound = moduli.lambda()(0) * one * one.transpose() +
                                            2.0 * moduli.shear(0) * Eigen::Matrix<double, 9, 9>::Identity();
  const Eigen::Matrix<double, 9, 9> excess = 0.5 * (power + power.transpose()) - bound;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(excess).eigenvalues()(8);
}

}  // namespace contactsim::test
