// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "core/elements/shell_kernel.hpp"
#include "core/materials/material_law.hpp"

/// A step of shells whose Geometry is as QuadShell.
namespace contactsim {

namespace shells {

/// Sums of the layers' stresses, per area, and the work of the step on them.
struct Resultants {
  std::array<Lanes, 3> membrane, curvature;
  std::array<Lanes, 2> shear;
  Lanes work;
};

/// Brings the layers to the end of the step.
///   rates   in the middle of the step [1/time], [1/(length time)]
///   layers  [n_layers x (6 + n_state)] xx yy zz xy yz zx, then what the material remembers
template <class Law, std::size_t n>
Resultants update_layers(const Law& law, const ShellSettings& settings, const ShellRates<n>& rates,
                         const Lanes& thickness, double dt, std::span<Lanes> layers) {
  Resultants sums;
  for (Lanes& sum : sums.membrane) sum.setZero();
  for (Lanes& sum : sums.curvature) sum.setZero();
  for (Lanes& sum : sums.shear) sum.setZero();
  sums.work.setZero();
  constexpr std::size_t point_size = 6 + Law::n_state;
  for (std::size_t layer = 0; layer < settings.layers.size(); ++layer) {
    const ShellLayer& at = settings.layers[layer];
    const std::span<Lanes> point = layers.subspan(layer * point_size, point_size);
    const Lanes height = thickness * (0.5 * at.place + settings.offset), weight = at.weight * thickness;
    PlaneStep step{{}, dt};
    for (std::size_t i = 0; i < 3; ++i)
      step.strain[i] = dt * (rates.membrane[i] + height * rates.curvature[i]);
    step.strain[3] = dt * rates.shear[1];
    step.strain[4] = dt * rates.shear[0];
    PlaneLanes before, stress;
    for (std::size_t i = 0; i < 5; ++i) stress[i] = before[i] = point[plane_places[i]];
    law.update_plane(step, stress, point.subspan(6));
    Lanes work = Lanes::Zero();
    for (std::size_t i = 0; i < 5; ++i) {
      point[plane_places[i]] = stress[i];
      work += (i < 3 ? 0.5 : 0.5 * shear_correction) * step.strain[i] * (before[i] + stress[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      sums.membrane[i] += weight * stress[i];
      sums.curvature[i] += weight * height * stress[i];
    }
    sums.shear[0] += shear_correction * weight * stress[4];
    sums.shear[1] += shear_correction * weight * stress[3];
    sums.work += weight * work;
  }
  return sums;
}

/// Moduli that bound a shell's stiffness: a rate D of strain in the surface meets a power of the stress rate
/// of at most lambda (tr D)^2 + 2 shear D : D, and angles across the thickness one of `across` times their
/// squares.
struct ShellModuli {
  double lambda, shear, across, youngs;

  explicit ShellModuli(const MaterialLaw& law) {
    const ElasticModuli moduli = moduli_of(law);
    const PlaneModuli plane(moduli);
    lambda = std::max(plane.across, 0.0);
    shear = moduli.shear;
    across = moduli.shear;
    youngs = 9.0 * moduli.bulk * moduli.shear / (3.0 * moduli.bulk + moduli.shear);
  }
};

/// The stiffness of a kind of patterns, times their scale.
inline Lanes pattern_stiffness(PatternKind kind, const ShellSettings& settings, const ShellModuli& moduli,
                               const ShellSizes& sizes, const Lanes& thickness) {
  const Lanes volume = sizes.area * thickness;
  switch (kind) {
    case PatternKind::membrane:
      return settings.membrane_hourglass * 0.5 * moduli.youngs * volume * sizes.gram_trace();
    case PatternKind::bending:
      return settings.bending_hourglass / 48.0 * moduli.youngs * volume * thickness * thickness *
             sizes.gram_trace();
    case PatternKind::shear:
      break;
  }
  return settings.shear_hourglass * shear_correction / 48.0 * moduli.across * volume;
}

/// A bound for the squared frequency of the strains. With amplitudes V and W of motion in the surface and
/// along the normal, and T of turning, the layers give at most [[a, b], [b, d]] in V and T, the shear a rank
/// of size p + q in W and T: the largest eigenvalue of [[a, b], [b, d + p + q]] bounds them all.
///   per_node   share of a node in the element [1]
template <std::size_t n>
Lanes strain_frequency(const ShellMotion<n>& motion, const ShellSettings& settings, const ShellModuli& moduli,
                       const ShellSizes& sizes) {
  double first = 0.0, second = 0.0;  // moments of the layers about the nodes
  for (const ShellLayer& layer : settings.layers) {
    const double height = 0.5 * layer.place + settings.offset;
    first += layer.weight * height;
    second += layer.weight * height * height;
  }
  const Lanes& t = motion.thickness;
  const Lanes warp = sizes.warp * t;  // moments by powers of the thickness
  const Lanes largest = sizes.gram_eigenvalue();
  const Lanes in_plane = sizes.area * t * (moduli.lambda * sizes.gram_trace() + 2.0 * moduli.shear * largest);
  const Lanes across = shear_correction * moduli.across * sizes.area * t;
  const Lanes per_mass = static_cast<double>(n) / motion.mass;
  const Lanes per_inertia = static_cast<double>(n) / motion.inertia;
  const Lanes tilted = 1.0 + sizes.tilt;
  const Lanes a = in_plane * per_mass * (1.0 + 2.0 * std::abs(first) * warp + second * warp * warp);
  const Lanes b = in_plane * t * (std::abs(first) + second * warp) * (tilted * per_mass * per_inertia).sqrt();
  const Lanes d = in_plane * t * t * second * tilted * per_inertia;
  const Lanes shear = across * (largest * per_mass + sizes.shear_by_turning * per_inertia);
  const Lanes half = 0.5 * (a - d - shear);
  return 0.5 * (a + d + shear) + (half * half + b * b).sqrt();
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
  Lanes frequency_squared = shells::strain_frequency(motion, settings, moduli, sizes);
  const Lanes per_mass = static_cast<double>(Geometry::n_nodes) / motion.mass;
  const Lanes per_inertia = static_cast<double>(Geometry::n_nodes) / motion.inertia;
  const auto pattern_sizes = geometry.pattern_sizes();
  typename Geometry::Rates resistance;
  step.hourglass_work.setZero();
  for (std::size_t k = 0; k < Geometry::n_patterns; ++k) {
    const PatternSizes& pattern = pattern_sizes[k];
    const Lanes stiffness = pattern.scale * shells::pattern_stiffness(Geometry::kinds[k], settings, moduli,
                                                                      sizes, motion.thickness);
    const Lanes rate = rates.patterns[k], growth = motion.dt * stiffness * rate;
    Lanes& elastic = state[n_layers + k];
    elastic += growth;
    step.hourglass_work += motion.dt * rate * (elastic - 0.5 * growth);
    frequency_squared += stiffness * (pattern.by_moving * per_mass + pattern.by_turning * per_inertia);
    resistance.patterns[k] = elastic;
  }
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
