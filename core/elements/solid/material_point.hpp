// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/elements/solid/rotation.hpp"
#include "core/materials/material_law.hpp"

namespace contactsim {

/// What a step does at an integration point of eight elements.
struct PointStep {
  SymmetricLanes stress;  ///< Cauchy, at the end of the step [force/length^2]
  Lanes work;             ///< of the stress in the step, per volume [energy/length^3]
  LaneModuli moduli;      ///< that bound the stiffness at its end
};

/// Turns stress and tensors of the material with the step's rotation and has the law bring them to its end.
/// The strain is that of the middle of the step: half of it counts before the rotation and half after. Turned
/// by the mean, what it adds is off by no more than the square of the rotation and does no net work as the
/// element turns; all of it before or after the rotation would be a circulatory force that makes vibrations
/// grow. The work is that of the stresses at both ends. Source: Rubinstein and Atluri, Comput. Meth. Appl.
/// Mech. Eng. 36 (1983) 277-290, for where the increment belongs.
///   point  [6 + n_state] stress (xx yy zz xy yz zx), then what the material remembers
PointStep update_point(const MaterialLaw& law, const StepMotion& motion, std::span<Lanes> point);

}  // namespace contactsim
