// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/materials/strain_step.hpp"

/// What laws have in common whose stress follows from the left Cauchy-Green tensor B; it is their state.
namespace contactsim::hyperelastic {

/// The deformation gradient of a step, (I + G/2) (I - G/2)^-1 = 2 (I - G/2)^-1 - I, G by coordinates in its
/// middle.
inline TensorLanes deformation_of(const TensorLanes& gradient) {
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

/// The determinant of a symmetric tensor.
inline Lanes determinant(const SymmetricLanes& b) {
  return b[0] * (b[1] * b[2] - b[4] * b[4]) - b[3] * (b[3] * b[2] - b[4] * b[5]) +
         b[5] * (b[3] * b[4] - b[1] * b[5]);
}

/// Of the norm of a deviator its largest eigenvalue is at most this share: sqrt(2/3).
inline constexpr double largest_share = 0.81649658092772603;

/// Bounds of the energy
///   bulk/4 (J^2 - 1) - bulk/2 ln J + shear/2 (J^(-2/3) tr B - 3).
/// With J c the tangent of the Kirchhoff stress's Lie derivative, s its deviator and L a velocity gradient,
///   D : J c : D + tau : L^T L = bulk J^2 tr^2 - bulk/2 (J^2 - 1) L : L^T
///                               + 2 m (D : D - tr^2 / 3) - 4/3 (s : D) tr + s : L^T L,  m = mean shear,
/// of which every term is bounded by tr^2 and L : L. Cauchy-Schwarz for s : D; the largest eigenvalue of s is
/// at most sqrt(2/3) of its norm.
///   volume     J [1]
///   mean       m [force/length^2]
///   deviation  norm of s [force/length^2]
inline LaneModuli tangent_bounds(double bulk, const Lanes& volume, const Lanes& mean,
                                 const Lanes& deviation) {
  const Lanes squared = volume * volume;
  const Lanes lambda = (bulk * squared - 2.0 / 3.0 * mean + 2.0 / 3.0 * deviation).max(0.0);
  const Lanes shear =
      mean + (1.0 / 3.0 + 0.5 * largest_share) * deviation + 0.25 * bulk * (squared - 1.0).abs();
  return {(lambda + 2.0 / 3.0 * shear) / volume, shear / volume};
}

/// What a deformation gives.
struct Response {
  SymmetricLanes stress;  ///< Cauchy [force/length^2]
  LaneModuli bounds;      ///< of the tangent and the stress's own share
  Lanes mean;             ///< m / J: the part of bounds.shear that no spin meets [force/length^2]
};

/// Undeformed material.
inline void start(std::span<Lanes> state) {
  for (std::size_t i = 0; i < 6; ++i) state[i].setConstant(i < 3 ? 1.0 : 0.0);
}

/// Makes f B f^T of B, f the step's own deformation gradient, which the step's rotation is a part of. Returns
/// it.
inline SymmetricLanes carry_along(const StrainStep& step, std::span<Lanes> state) {
  SymmetricLanes b{{state[0], state[1], state[2], state[3], state[4], state[5]}};
  b = transformed(b, deformation_of(step.gradient));
  for (std::size_t i = 0; i < 6; ++i) state[i] = b[i];
  return b;
}

}  // namespace contactsim::hyperelastic
