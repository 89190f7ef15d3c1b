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
StepMotion split_motion(const TensorLanes& velocity_gradient, double dt);

}  // namespace contactsim
