// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/elements/rotation.hpp"
#include "core/materials/material_law.hpp"

namespace contactsim {

/// What a step does at an integration point of eight elements.
struct PointStep {
  SymmetricLanes stress;  ///< Cauchy, at the end of the step [force/length^2]
  Lanes work;             ///< of the stress in the step, per volume [energy/length^3]
  LaneModuli moduli;      ///< that bound the stiffness at its end
};

/// Turns stress and tensors of the material with the step's rotation, then has the law bring them to its end.
///   point  [6 + n_state] stress (xx yy zz xy yz zx), then what the material remembers
PointStep update_point(const MaterialLaw& law, const StepMotion& motion, std::span<Lanes> point);

}  // namespace contactsim
