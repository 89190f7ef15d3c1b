// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/hex_geometry.hpp"

namespace contactsim {

/// Strain and rotation of a step, from the velocity gradient at its middle.
struct StepMotion {
  SymmetricLanes strain;  ///< increment [1]
  TensorLanes rotation;   ///< proper orthogonal [1]
};

/// Splits the gradient of the displacement increment at the middle of a step. A step of pure rotation,
/// however large, has no strain, and exactly its rotation. Source: Hughes and Winget, Int. J. Numer. Meth.
/// Eng. 15 (1980) 1862-1867.
StepMotion split_motion(const TensorLanes& gradient);

/// R a R^T.
SymmetricLanes turned(const SymmetricLanes& a, const TensorLanes& rotation);

/// R v for the vector (v[0][k], v[1][k], v[2][k]) of each k, in place.
template <std::size_t n>
void turn(const TensorLanes& rotation, std::array<std::array<Lanes, n>, 3>& v) {
  for (std::size_t k = 0; k < n; ++k) {
    const Lanes x = v[0][k], y = v[1][k], z = v[2][k];
    for (std::size_t i = 0; i < 3; ++i)
      v[i][k] = rotation[i][0] * x + rotation[i][1] * y + rotation[i][2] * z;
  }
}

}  // namespace contactsim
