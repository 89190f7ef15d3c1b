// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/elements/solid/midpoint_kinematics.hpp"

/// Resistance to the motions of uniform-gradient elements that have no mean gradient.
/// Source: Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679-706.
namespace contactsim {

/// Rates of the hourglass modes: what is left of the velocities without their linear part [length/time].
template <class Geometry>
ModeVectors<Geometry> hourglass_rates(const BaseVectors<Geometry>& v,
                                      const MidpointKinematics<Geometry>& midpoint) {
  const ModeVectors<Geometry>& x = midpoint.x_modes;
  ModeVectors<Geometry> rates = mode_sums<Geometry>(v);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = midpoint.velocity_gradient[i];
    for (std::size_t k = 0; k < Geometry::n_modes; ++k) {
      rates[i][k] = (rates[i][k] - row[0] * x[0][k] - row[1] * x[1][k] - row[2] * x[2][k]) *
                    (1.0 / Geometry::mode_norm);
    }
  }
  return rates;
}

/// The work that hourglass forces take up in a step [energy], and the forces at its end [force].
template <class Geometry>
struct HourglassStep {
  ModeVectors<Geometry> force;
  Lanes work = Lanes::Zero();
};

/// Turns the vectors (v[k], v[n + k], v[2 n + k]), n their number.
inline void turn_vectors(const TensorLanes& rotation, std::span<Lanes> v) {
  const std::size_t n = v.size() / 3;
  for (std::size_t k = 0; k < n; ++k) {
    const Lanes x = v[k], y = v[n + k], z = v[2 * n + k];
    for (std::size_t i = 0; i < 3; ++i)
      v[i * n + k] = rotation[i][0] * x + rotation[i][1] * y + rotation[i][2] * z;
  }
}

/// Adds viscous forces and their work.
///   viscosity  [force time/length]
template <class Geometry>
void damp_hourglass(const ModeVectors<Geometry>& rates, const Lanes& viscosity, double dt,
                    HourglassStep<Geometry>& step) {
  Lanes power = Lanes::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < Geometry::n_modes; ++k) {
      const Lanes damping = viscosity * rates[i][k];
      power += damping * rates[i][k];
      step.force[i][k] += damping;
    }
  }
  step.work += dt * power;
}

/// The viscosity of a block's hourglass resistance, if it has any [force time/length].
///   stiffness  [force/length]
inline std::optional<Lanes> hourglass_viscosity(const ElementProperties& properties, const Lanes& mass,
                                                const Lanes& stiffness) {
  if (properties.hourglass_viscosity == 0.0) return std::nullopt;
  return properties.hourglass_viscosity * (mass * stiffness).sqrt();
}

/// Brings the elastic hourglass forces to the end of the step and adds the viscous ones. What the elastic
/// ones grow by is added half before the step's rotation and half after, as update_point does.
///   motion     of base sums
///   stiffness  [force/length]
///   viscosity  if there is any [force time/length]
///   rotation   of the step
///   elastic    [3 x n_modes]
template <class Geometry>
HourglassStep<Geometry> update_hourglass(const SolidMotion<Geometry::n_base>& motion,
                                         const MidpointKinematics<Geometry>& midpoint, const Lanes& stiffness,
                                         const std::optional<Lanes>& viscosity, const TensorLanes& rotation,
                                         std::span<Lanes> elastic) {
  constexpr std::size_t n = Geometry::n_modes;
  HourglassStep<Geometry> step;
  const ModeVectors<Geometry> rates = hourglass_rates<Geometry>(motion.v, midpoint);
  const Lanes half = 0.5 * motion.dt * stiffness;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      step.work += rates[i][k] * elastic[i * n + k];
      elastic[i * n + k] += half * rates[i][k];
    }
  }
  turn_vectors(rotation, elastic);
  Lanes end_power = Lanes::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      Lanes& force = elastic[i * n + k];
      force += half * rates[i][k];
      end_power += rates[i][k] * force;
      step.force[i][k] = force;
    }
  }
  step.work = 0.5 * motion.dt * (step.work + end_power);
  if (viscosity) damp_hourglass<Geometry>(rates, *viscosity, motion.dt, step);
  return step;
}

}  // namespace contactsim
