// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/membrane_tension.hpp"
#include "core/elements/shell_drilling.hpp"
#include "core/elements/shell_layers.hpp"

/// A step of shells whose Geometry is as QuadShell.
namespace contactsim {

namespace shells {

/// Bulk viscosity of the surface: as that of solids, of its area in place of the volume. Its share in
/// critical damping is that of a uniform dilatation, which is the least stiff against its trace.
struct SurfaceViscosity {
  Lanes stress;       ///< to be added to the diagonal [force/length^2]
  Lanes stable_step;  ///< the undamped one shortened by the viscosity [time]

  ///   undamped    stable step without viscosity [time]
  ///   dilatation  rate of area change [1/time]
  SurfaceViscosity(const SolidProperties& properties, const ShellModuli& moduli, const Lanes& undamped,
                   const Lanes& dilatation) {
    const double quadratic = properties.quadratic_bulk_viscosity * properties.quadratic_bulk_viscosity;
    const double direct = moduli.lambda + 2.0 * moduli.shear;
    const Lanes share = properties.linear_bulk_viscosity - quadratic * undamped * dilatation.min(0.0);
    const Lanes damping = direct / (moduli.lambda + moduli.shear) * share;
    stress = direct * undamped * share * dilatation;
    stable_step = undamped * ((1.0 + damping * damping).sqrt() - damping);
  }
};

/// The parts of what shells remember.
struct ShellMemory {
  std::span<Lanes> layers;    ///< [n_layers x (6 + n_state)]
  std::span<Lanes> patterns;  ///< [n_patterns] elastic resistance
  std::span<Lanes> drilling;  ///< [n_nodes] moments, or none [force length]
  Lanes& growth;              ///< of the thickness over that at the start of the run [1]

  ///   state  [n_layers x (6 + n_state) + n_patterns (+ n_nodes) + 1], in the order above
  ShellMemory(std::span<Lanes> state, std::size_t n_patterns, std::size_t n_drilling)
      : layers(state.first(state.size() - 1 - n_drilling - n_patterns)),
        patterns(state.subspan(layers.size(), n_patterns)),
        drilling(state.subspan(layers.size() + n_patterns, n_drilling)),
        growth(state.back()) {}
};

/// What the patterns of a step are resisted by.
template <class Geometry>
struct PatternStep {
  const Geometry& geometry;
  const ShellSettings& settings;
  const ShellModuli& moduli;
  const ShellSizes& sizes;
  const ShellMotion<Geometry::n_nodes>& motion;
};

/// Brings the elastic resistance to patterns to the end of the step; returns the work on it in the step.
///   elastic            [n_patterns]
///   resistance         its patterns are set
///   frequency_squared  what patterns add to the bound is added [1/time^2]
template <class Geometry>
Lanes resist_patterns(const PatternStep<Geometry>& step, const typename Geometry::Rates& rates,
                      std::span<Lanes> elastic, typename Geometry::Rates& resistance,
                      Lanes& frequency_squared) {
  const auto& motion = step.motion;
  const Lanes per_mass = static_cast<double>(Geometry::n_nodes) / motion.mass;
  const Lanes per_inertia = static_cast<double>(Geometry::n_nodes) / motion.inertia;
  const auto sizes = step.geometry.pattern_sizes();
  Lanes work = Lanes::Zero();
  for (std::size_t k = 0; k < Geometry::n_patterns; ++k) {
    const Lanes stiffness = sizes[k].scale * pattern_stiffness(Geometry::kinds[k], step.settings, step.moduli,
                                                               step.sizes, motion.thickness);
    const Lanes rate = rates.patterns[k], growth = motion.dt * stiffness * rate;
    elastic[k] += growth;
    work += motion.dt * rate * (elastic[k] - 0.5 * growth);
    frequency_squared += stiffness * (sizes[k].by_moving * per_mass + sizes[k].by_turning * per_inertia);
    resistance.patterns[k] = elastic[k];
  }
  return work;
}

}  // namespace shells

/// Brings eight shells to the end of a step: strains from the rates in the middle of the step, stresses in a
/// frame that turns with the shells, elastic resistance to the patterns and to drilling, bulk viscosity. The
/// thickness follows the strain along the normal, its mean over the layers. The stable step is
/// 2 / omega (sqrt(1 + z^2) - z) with a bound omega for the element's frequencies and z the viscosity's share
/// in critical damping.
///   state  as ShellMemory
template <class Geometry>
void advance_shell(const SolidProperties& properties, const ShellSettings& settings,
                   const ShellMotion<Geometry::n_nodes>& motion, std::span<Lanes> state,
                   ShellStep<Geometry::n_nodes>& step) {
  NodeVectors<Geometry::n_nodes> middle = motion.x;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < Geometry::n_nodes; ++a) middle[i][a] -= 0.5 * motion.dt * motion.v[i][a];
  }
  const Geometry geometry(middle);
  const auto rates = geometry.rates(motion.v, motion.w);
  const ShellSizes sizes = geometry.sizes();
  const shells::ShellModuli moduli(properties.law);
  const shells::ShellMemory memory(state, Geometry::n_patterns,
                                   settings.drilling > 0.0 ? Geometry::n_nodes : 0);
  const shells::Resultants sums = shells::update_layers(
      properties.law,
      shells::LayerStep<Geometry::n_patterns>{settings, rates, motion.thickness, motion.dt, moduli.bulk},
      memory.layers);
  const shells::ThicknessStep thickness(motion.thickness, sums.thickening, memory.growth);
  step.stress_work = sums.work * sizes.area * thickness.middle;

  Lanes frequency_squared = shells::strain_frequency(motion, settings, moduli, sizes);
  typename Geometry::Rates resistance;
  step.hourglass_work = shells::resist_patterns<Geometry>(
      shells::PatternStep<Geometry>{geometry, settings, moduli, sizes, motion}, rates, memory.patterns,
      resistance, frequency_squared);
  if (!memory.drilling.empty()) {
    const Lanes stiffness = settings.drilling * moduli.shear / static_cast<double>(Geometry::n_nodes) *
                            sizes.area * motion.thickness;
    step.hourglass_work +=
        shells::resist_drilling(geometry, motion, stiffness, memory.drilling, frequency_squared);
  }
  constexpr bool is_flattened = requires { geometry.warp(); }
  &&!Geometry::has_rotations;
  if constexpr (is_flattened) {
    const auto of_warp = shells::warp_step(geometry, motion, sums.membrane);
    step.hourglass_work += of_warp.work;
    frequency_squared += of_warp.frequency_squared;
  }
  const Lanes dilatation = rates.membrane[0] + rates.membrane[1];
  const shells::SurfaceViscosity viscosity(properties, moduli, 2.0 / frequency_squared.sqrt(), dilatation);
  step.stable_step = viscosity.stable_step;
  step.viscous_work = viscosity.stress * dilatation * sizes.area * thickness.middle * motion.dt;

  const Geometry end(motion.x);
  step.volume = end.area() * thickness.end;
  for (std::size_t i = 0; i < 3; ++i) {
    resistance.membrane[i] = step.volume * sums.membrane[i];
    resistance.curvature[i] = step.volume * thickness.end * sums.curvature[i];
  }
  for (std::size_t i = 0; i < 2; ++i) {
    resistance.membrane[i] += step.volume * viscosity.stress;
    resistance.shear[i] = step.volume * sums.shear[i];
  }
  end.set_forces(resistance, step.force, step.moment);
  if constexpr (is_flattened) shells::add_warp_forces(end, sums.membrane, step.volume, step.force);
  if (!memory.drilling.empty()) shells::add_drilling(end, memory.drilling, step.force, step.moment);
}

}  // namespace contactsim
