// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/shell_drilling.hpp"

/// What shells remember, and their elastic resistance to what no strain sees.
namespace contactsim::shells {

/// The parts of what shells remember.
struct ShellMemory {
  std::span<Lanes> layers;     ///< [n_layers x (6 + n_state)]
  std::span<Lanes> hourglass;  ///< [n_modes] elastic resistance
  std::span<Lanes> drilling;   ///< [n_nodes] moments, or none [force length]
  Lanes& growth;               ///< of the thickness over that at the start of the run [1]

  ///   state  [n_layers x (6 + n_state) + n_modes (+ n_nodes) + 1], in the order above
  ShellMemory(std::span<Lanes> state, std::size_t n_modes, std::size_t n_drilling)
      : layers(state.first(state.size() - 1 - n_drilling - n_modes)),
        hourglass(state.subspan(layers.size(), n_modes)),
        drilling(state.subspan(layers.size() + n_modes, n_drilling)),
        growth(state.back()) {}
};

/// What the hourglass modes of a step are resisted by.
template <class Geometry>
struct ShellHourglassStep {
  const Geometry& geometry;
  const ShellSettings& settings;
  const ShellModuli& moduli;
  const ShellSizes& sizes;
  const ShellMotion<Geometry::n_nodes>& motion;
};

/// Brings the elastic resistance to hourglass modes to the end of the step; returns the work on it in the
/// step.
///   elastic            [n_modes]
///   resistance         its hourglass modes are set
///   frequency_squared  what hourglass modes add to the bound is added [1/time^2]
template <class Geometry>
Lanes resist_hourglass_modes(const ShellHourglassStep<Geometry>& step, const typename Geometry::Rates& rates,
                             std::span<Lanes> elastic, typename Geometry::Rates& resistance,
                             Lanes& frequency_squared) {
  const auto& motion = step.motion;
  const Lanes per_mass = static_cast<double>(Geometry::n_nodes) / motion.mass;
  const Lanes per_inertia = static_cast<double>(Geometry::n_nodes) / motion.inertia;
  const auto sizes = step.geometry.hourglass_sizes();
  Lanes work = Lanes::Zero();
  for (std::size_t k = 0; k < Geometry::n_modes; ++k) {
    const Lanes stiffness = sizes[k].scale * mode_stiffness(Geometry::kinds[k], step.settings, step.moduli,
                                                            step.sizes, motion.thickness);
    const Lanes rate = rates.hourglass[k], growth = motion.dt * stiffness * rate;
    elastic[k] += growth;
    work += motion.dt * rate * (elastic[k] - 0.5 * growth);
    frequency_squared += stiffness * (sizes[k].by_moving * per_mass + sizes[k].by_turning * per_inertia);
    resistance.hourglass[k] = elastic[k];
  }
  return work;
}

/// Brings hourglass modes and drilling to the end of the step, as resist_hourglass_modes.
template <class Geometry>
Lanes resist_beyond_strain(const ShellHourglassStep<Geometry>& step, const typename Geometry::Rates& rates,
                           const ShellMemory& memory, typename Geometry::Rates& resistance,
                           Lanes& frequency_squared) {
  const Lanes work = resist_hourglass_modes(step, rates, memory.hourglass, resistance, frequency_squared);
  if (memory.drilling.empty()) return work;
  const Lanes stiffness = step.settings.drilling * step.moduli.shear /
                          static_cast<double>(Geometry::n_nodes) * step.sizes.area * step.motion.thickness;
  return work + resist_drilling(step.geometry, step.motion, stiffness, memory.drilling, frequency_squared);
}

}  // namespace contactsim::shells
