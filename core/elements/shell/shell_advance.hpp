// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/membrane_tension.hpp"
#include "core/elements/shell/shell_layers.hpp"
#include "core/elements/shell/shell_resistance.hpp"

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
  SurfaceViscosity(const ElementProperties& properties, const ShellModuli& moduli, const Lanes& undamped,
                   const Lanes& dilatation) {
    const double quadratic = properties.quadratic_bulk_viscosity * properties.quadratic_bulk_viscosity;
    const double direct = moduli.lambda + 2.0 * moduli.shear;
    const Lanes share = properties.linear_bulk_viscosity - quadratic * undamped * dilatation.min(0.0);
    const Lanes damping = direct / (moduli.lambda + moduli.shear) * share;
    stress = direct * undamped * share * dilatation;
    stable_step = undamped * ((1.0 + damping * damping).sqrt() - damping);
  }
};

/// Whether tension has to flatten a surface; one with transverse shear has that for it.
template <class Geometry>
constexpr bool is_flattened = !Geometry::has_rotations && requires(const Geometry& geometry) {
  geometry.warp();
};

/// Sets the forces at the end of the step.
///   sums        bulk viscosity included
///   thickness   at the end [length]
///   resistance  its hourglass modes are set
template <class Geometry>
void set_end_forces(const ShellMotion<Geometry::n_nodes>& motion, const Resultants& sums,
                    const Lanes& thickness, typename Geometry::Rates& resistance,
                    ShellStep<Geometry::n_nodes>& step) {
  const Geometry end(motion.x);
  step.volume = end.area() * thickness;
  for (std::size_t i = 0; i < 3; ++i) {
    resistance.membrane[i] = step.volume * sums.membrane[i];
    resistance.curvature[i] = step.volume * thickness * sums.curvature[i];
  }
  for (std::size_t i = 0; i < 2; ++i) resistance.shear[i] = step.volume * sums.shear[i];
  end.set_forces(resistance, step.force, step.moment);
  if constexpr (is_flattened<Geometry>) add_warp_forces(end, sums.membrane, step.volume, step.force);
}

}  // namespace shells

/// Brings eight shells to the end of a step: strains from the rates in the middle of the step, stresses in a
/// frame that turns with the shells, elastic resistance to the hourglass modes and to drilling, bulk
/// viscosity. The thickness follows the strain along the normal, its mean over the layers. The stable step is
/// 2 / omega (sqrt(1 + z^2) - z) with a bound omega for the element's frequencies and z the viscosity's share
/// in critical damping.
///   state  as ShellMemory
template <class Geometry>
void advance_shell(const ElementProperties& properties, const ShellSettings& settings,
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
  const shells::ShellMemory memory(state, Geometry::n_modes, settings.drilling > 0.0 ? Geometry::n_nodes : 0);
  shells::Resultants sums = shells::update_layers(
      properties.law,
      shells::LayerStep<Geometry::n_modes>{settings, rates, motion.thickness, motion.dt, moduli.bulk},
      memory.layers);
  const shells::ThicknessStep thickness(motion.thickness, sums.thickening, memory.growth);
  step.stress_work = sums.work * sizes.area * thickness.middle;

  Lanes frequency_squared = sums.stiffening * shells::strain_frequency(motion, settings, moduli, sizes);
  typename Geometry::Rates resistance;
  step.hourglass_work = shells::resist_beyond_strain(
      shells::ShellHourglassStep<Geometry>{geometry, settings, moduli, sizes, motion}, rates, memory,
      resistance, frequency_squared);
  if constexpr (shells::is_flattened<Geometry>) {
    const auto warping = shells::warp_step(geometry, motion, sums.membrane);
    step.hourglass_work += warping.work;
    frequency_squared += warping.frequency_squared;
  }
  const Lanes dilatation = rates.membrane[0] + rates.membrane[1];
  const shells::SurfaceViscosity viscosity(properties, moduli, 2.0 / frequency_squared.sqrt(), dilatation);
  step.stable_step = viscosity.stable_step;
  step.viscous_work = viscosity.stress * dilatation * sizes.area * thickness.middle * motion.dt;

  for (std::size_t i = 0; i < 2; ++i) sums.membrane[i] += viscosity.stress;
  shells::set_end_forces<Geometry>(motion, sums, thickness.end, resistance, step);
  if (!memory.drilling.empty())
    shells::add_drilling(Geometry(motion.x), memory.drilling, step.force, step.moment);
}

}  // namespace contactsim
