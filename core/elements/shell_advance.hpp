// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell_layers.hpp"
#include "core/elements/shell_stiffness.hpp"

/// A step of shells whose Geometry is as QuadShell.
namespace contactsim {

namespace shells {

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
/// frame that turns with the shells, elastic and viscous resistance to the patterns. The thickness does not
/// change. The stable step is 2 / omega with a bound omega for the element's frequencies.
///   state  [n_layers x (6 + n_state) + n_patterns], the last the elastic resistance to the patterns
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
  const std::size_t n_layers = state.size() - Geometry::n_patterns;
  const auto sums = std::visit(
      [&](const auto& law) {
        if constexpr (requires { &std::decay_t<decltype(law)>::update_plane; }) {
          return shells::update_layers(law, settings, rates, motion.thickness, motion.dt,
                                       state.first(n_layers));
        } else {
          return shells::Resultants{};  // make_model lets no such law come here
        }
      },
      properties.law);
  step.stress_work = sums.work * sizes.area;

  const shells::ShellModuli moduli(properties.law);
  Lanes frequency_squared = sums.stiffening * shells::strain_frequency(motion, settings, moduli, sizes);
  typename Geometry::Rates resistance;
  step.hourglass_work = shells::resist_patterns<Geometry>(
      shells::PatternStep<Geometry>{geometry, settings, moduli, sizes, motion}, rates,
      state.subspan(n_layers), resistance, frequency_squared);
  step.stable_step = 2.0 / frequency_squared.sqrt();

  const Geometry end(motion.x);
  for (std::size_t i = 0; i < 3; ++i) {
    resistance.membrane[i] = end.area() * sums.membrane[i];
    resistance.curvature[i] = end.area() * sums.curvature[i];
  }
  for (std::size_t i = 0; i < 2; ++i) resistance.shear[i] = end.area() * sums.shear[i];
  end.set_forces(resistance, step.force, step.moment);
  step.volume = end.area() * motion.thickness;
}

}  // namespace contactsim
