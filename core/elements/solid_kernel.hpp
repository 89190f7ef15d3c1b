// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/base/tensor_lanes.hpp"
#include "core/elements/element_properties.hpp"

/// What every kernel of a solid element takes and gives.
namespace contactsim {

/// How eight elements of n nodes move in a step.
template <std::size_t n>
struct SolidMotion {
  NodeVectors<n> x;  ///< coordinates at the end of the step [length]
  NodeVectors<n> v;  ///< velocities at its middle [length/time]
  Lanes mass;        ///< of the elements [mass]
  double dt = 0.0;   ///< size of the step; 0: forces at the start are asked for [time]
};

/// What a step gives.
template <std::size_t n>
struct SolidStep {
  NodeVectors<n> force;  ///< as it acts on the nodes at the end of the step [force]
  Lanes volume;          ///< at the end of the step [length^3]
  Lanes stable_step;     ///< [time]
  Lanes stress_work;     ///< done on the material's stress in the step [energy]
  Lanes hourglass_work;  ///< done on the hourglass forces in the step [energy]
  Lanes viscous_work;    ///< done on the bulk viscosity in the step [energy]
};

}  // namespace contactsim
