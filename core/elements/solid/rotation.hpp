// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/strain_step.hpp"

namespace contactsim {

/// Strain and rotation of a step.
struct StepMotion {
  StrainStep strain;
  TensorLanes rotation;  ///< proper orthogonal [1]
};

/// Splits the motion of a step. A step of pure rotation, however large, has no strain, and exactly its
/// rotation. Source: Hughes and Winget, Int. J. Numer. Meth. Eng. 15 (1980) 1862-1867.
///   velocity_gradient  in the middle of the step [1/time]
inline StepMotion split_motion(const TensorLanes& velocity_gradient, double dt) {
  StepMotion motion;
  TensorLanes& g = motion.strain.gradient;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) g[i][j] = dt * velocity_gradient[i][j];
  }
  motion.strain.dt = dt;
  motion.strain.strain = {{g[0][0], g[1][1], g[2][2], 0.5 * (g[0][1] + g[1][0]), 0.5 * (g[1][2] + g[2][1]),
                           0.5 * (g[2][0] + g[0][2])}};
  // Cayley's formula with the axial vector w of the skew part A: I + (A + A^2 / 2) / (1 + w.w / 4).
  const Lanes wx = 0.5 * (g[2][1] - g[1][2]), wy = 0.5 * (g[0][2] - g[2][0]), wz = 0.5 * (g[1][0] - g[0][1]);
  const Lanes xx = wx * wx, yy = wy * wy, zz = wz * wz;
  const Lanes scale = 1.0 / (1.0 + 0.25 * (xx + yy + zz)), half = 0.5 * scale;
  TensorLanes& r = motion.rotation;
  r[0] = {1.0 - half * (yy + zz), half * wx * wy - scale * wz, half * wx * wz + scale * wy};
  r[1] = {half * wx * wy + scale * wz, 1.0 - half * (xx + zz), half * wy * wz - scale * wx};
  r[2] = {half * wx * wz - scale * wy, half * wy * wz + scale * wx, 1.0 - half * (xx + yy)};
  return motion;
}

}  // namespace contactsim
