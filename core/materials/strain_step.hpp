// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/tensor_lanes.hpp"

namespace contactsim {

/// How eight elements deform in a step.
struct StrainStep {
  SymmetricLanes strain;  ///< increment, from the symmetric part of `gradient` [1]
  TensorLanes gradient;   ///< of the displacement increment by the coordinates in the middle of the step [1]
  double dt;              ///< size of the step; 0: the state at the start is asked for, nothing moves [time]
};

/// Moduli that bound the stiffness of eight elements now: a velocity gradient L meets a power of the stress
/// rate of at most lambda (tr L)^2 + 2 shear L : L.
struct LaneModuli {
  Lanes bulk;   ///< >= 2/3 shear, so that lambda >= 0 [force/length^2]
  Lanes shear;  ///< > 0 [force/length^2]

  Lanes lambda() const { return bulk - 2.0 / 3.0 * shear; }
  /// Modulus of the pressure wave [force/length^2].
  Lanes p_wave() const { return bulk + 4.0 / 3.0 * shear; }
};

}  // namespace contactsim
