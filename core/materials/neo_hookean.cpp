// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/neo_hookean.hpp"

namespace contactsim {

namespace {

/// The deformation gradient of a step, (I + G/2) (I - G/2)^-1 = 2 (I - G/2)^-1 - I, G by coordinates in its
/// middle.
TensorLanes deformation_of(const TensorLanes& gradient) {
  TensorLanes d;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) d[i][j] = (i == j ? 1.0 : 0.0) - 0.5 * gradient[i][j];
  }
  TensorLanes f;  // first the transposed cofactors of d
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      f[j][i] = d[i1][j1] * d[i2][j2] - d[i1][j2] * d[i2][j1];
    }
  }
  const Lanes scale = 2.0 / (d[0][0] * f[0][0] + d[0][1] * f[1][0] + d[0][2] * f[2][0]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (Lanes& component : f[i]) component *= scale;
    f[i][i] -= 1.0;
  }
  return f;
}

Lanes determinant(const SymmetricLanes& b) {
  return b[0] * (b[1] * b[2] - b[4] * b[4]) - b[3] * (b[3] * b[2] - b[4] * b[5]) +
         b[5] * (b[3] * b[4] - b[1] * b[5]);
}

/// With J c the tangent of the Kirchhoff stress's Lie derivative, s its deviator and L a velocity gradient,
///   D : J c : D + tau : L^T L = bulk J^2 tr^2 - bulk/2 (J^2 - 1) L : L^T
///                               + 2 m (D : D - tr^2 / 3) - 4/3 (s : D) tr + s : L^T L,  m = mean shear,
/// of which every term is bounded by tr^2 and L : L. Cauchy-Schwarz for s : D; the largest eigenvalue of s is
/// at most sqrt(2/3) of its norm.
///   volume     J [1]
///   mean       m [force/length^2]
///   deviation  norm of s [force/length^2]
LaneModuli tangent_bounds(double bulk, const Lanes& volume, const Lanes& mean, const Lanes& deviation) {
  const Lanes squared = volume * volume;
  const Lanes lambda = (bulk * squared - 2.0 / 3.0 * mean + 2.0 / 3.0 * deviation).max(0.0);
  constexpr double largest = 0.81649658092772603;  // sqrt(2/3)
  const Lanes shear = mean + (1.0 / 3.0 + 0.5 * largest) * deviation + 0.25 * bulk * (squared - 1.0).abs();
  return {(lambda + 2.0 / 3.0 * shear) / volume, shear / volume};
}

}  // namespace

void NeoHookeanLaw::start(std::span<Lanes> state) const {
  for (std::size_t i = 0; i < 6; ++i) state[i].setConstant(i < 3 ? 1.0 : 0.0);
}

LaneModuli NeoHookeanLaw::update(const StrainStep& step, SymmetricLanes& stress,
                                 std::span<Lanes> state) const {
  SymmetricLanes b{{state[0], state[1], state[2], state[3], state[4], state[5]}};
  b = transformed(b, deformation_of(step.gradient));
  for (std::size_t i = 0; i < 6; ++i) state[i] = b[i];
  const Lanes squared = determinant(b), volume = squared.sqrt();
  const Lanes shear = moduli.shear * (-1.0 / 3.0 * squared.log()).exp();  // times J^(-2/3)
  const Lanes mean = shear * trace(b) / 3.0;
  stress = deviator(b);
  for (Lanes& component : stress.components) component *= shear;
  const Lanes deviation = contract(stress, stress).sqrt();
  const Lanes per_volume = 1.0 / volume;
  for (Lanes& component : stress.components) component *= per_volume;
  const Lanes pressure = 0.5 * moduli.bulk * (volume - per_volume);
  for (std::size_t i = 0; i < 3; ++i) stress[i] += pressure;
  return tangent_bounds(moduli.bulk, volume, mean, deviation);
}

}  // namespace contactsim
