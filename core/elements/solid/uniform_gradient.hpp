// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/elements/solid/bulk_viscosity.hpp"
#include "core/elements/solid/hourglass.hpp"
#include "core/elements/solid/material_point.hpp"
#include "core/mesh/topology.hpp"

/// Solid elements that take strain and stress as uniform, from the mean gradients of their shape functions.
/// Their kernel works in base vectors, see base_vectors.hpp.
namespace contactsim {

/// The forces of a stress and of hourglass forces, whose share of the linear motion is taken off. Sets the
/// volume.
template <class Geometry>
BaseVectors<Geometry> base_forces(const SymmetricLanes& stress, const ModeVectors<Geometry>& hourglass,
                                  const BaseVectors<Geometry>& x, Lanes& volume) {
  const auto gradient = Geometry::volume_gradient(x);
  volume = dot(gradient[0], x[0]);
  const ModeVectors<Geometry> sums = mode_sums<Geometry>(x);
  const Lanes scale = 1.0 / (Geometry::mode_norm * volume);
  BaseVectors<Geometry> forces;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Lanes, 3> row;  // of minus the stress
    for (std::size_t j = 0; j < 3; ++j) {
      row[j] = -stress[symmetric_place[i][j]];
      for (std::size_t k = 0; k < Geometry::n_modes; ++k) row[j] += scale * hourglass[i][k] * sums[j][k];
    }
    for (std::size_t a = 0; a < Geometry::n_gradient; ++a)
      forces[i][a] = row[0] * gradient[0][a] + row[1] * gradient[1][a] + row[2] * gradient[2][a];
    for (std::size_t a = Geometry::n_gradient; a < Geometry::n_base; ++a) forces[i][a].setZero();
    std::array<Lanes, Geometry::n_modes> amounts;
    for (std::size_t k = 0; k < Geometry::n_modes; ++k)
      amounts[k] = hourglass[i][k] * (-1.0 / Geometry::mode_norm);
    Geometry::add_modes(amounts, forces[i]);
  }
  return forces;
}

/// Brings eight elements to the end of a step. Strain from the gradient in the middle of the step, stress
/// turned by Hughes and Winget, hourglass resistance that vanishes for every linear velocity field, linear
/// and quadratic bulk viscosity. A volume that is not positive leaves numbers without meaning: look at
/// `volume`. The stable step is 2 / omega (sqrt(1 + z^2) - z), with z the share of bulk viscosity in critical
/// damping, and
///   omega^2 <= n_nodes / (m V) (lambda B:B + 2 mu e(B B^T) + k p B:B),
/// a bound for the element's frequencies (e the largest eigenvalue; by Cauchy-Schwarz, term by term; the last
/// one, of the hourglass modes, with p as MidpointKinematics::mode_bound). Source: Flanagan and Belytschko
/// (1981), Int. J. Numer. Meth. Eng. 17, 679-706, and (1984), J. Appl. Mech. 51, 35-40.
///   own  [3 x n_modes] hourglass forces
template <class Geometry>
void advance_uniform_gradient(const ElementProperties& properties,
                              const SolidMotion<Geometry::n_nodes>& nodal_motion, std::span<Lanes> point,
                              std::span<Lanes> own, SolidStep<Geometry::n_nodes>& step) {
  const SolidMotion<Geometry::n_base> motion = base_motion<Geometry>(nodal_motion);
  const MidpointKinematics<Geometry> midpoint(motion);
  const StepMotion split = split_motion(midpoint.velocity_gradient, motion.dt);
  PointStep at_point = update_point(properties.law, split, point);
  step.stress_work = at_point.work * midpoint.volume;

  const Lanes per_mass = 1.0 / motion.mass;
  const double hourglass_modulus =
      Geometry::n_modes > 0 ? properties.hourglass_stiffness * properties.law.moduli().shear : 0.0;
  const Lanes norm_modulus = at_point.moduli.lambda() + hourglass_modulus * midpoint.mode_bound;
  const Lanes frequency_squared =
      static_cast<double>(Geometry::n_nodes) * per_mass * midpoint.per_volume *
      (norm_modulus * midpoint.gradient_norm + 2.0 * at_point.moduli.shear * midpoint.largest_eigenvalue);
  const Lanes undamped = 2.0 / frequency_squared.sqrt();
  const Lanes wave_speed = (at_point.moduli.p_wave() * midpoint.volume * per_mass).sqrt();
  const BulkViscosity viscosity(properties, undamped, midpoint.dilatation(),
                                motion.mass * midpoint.per_volume, wave_speed);
  step.stable_step = viscosity.stable_step;
  step.viscous_work = viscosity.stress * midpoint.dilatation() * midpoint.volume * motion.dt;
  for (std::size_t i = 0; i < 3; ++i) at_point.stress[i] += viscosity.stress;

  const Lanes stiffness = hourglass_modulus * midpoint.gradient_norm * midpoint.per_volume;
  const auto viscosity_of_modes = hourglass_viscosity(properties, motion.mass, stiffness);
  const auto hourglass =
      update_hourglass<Geometry>(motion, midpoint, stiffness, viscosity_of_modes, split.rotation, own);
  step.hourglass_work = hourglass.work;
  set_nodal_forces<Geometry>(base_forces<Geometry>(at_point.stress, hourglass.force, motion.x, step.volume),
                             step);
}

/// An element of this kind: one integration point, hourglass forces of its own.
template <Shape its_shape, class Geometry>
struct UniformGradient {
  static constexpr Shape shape = its_shape;
  static constexpr std::string_view formulation = "mean_quadrature";
  static constexpr std::size_t n_nodes = Geometry::n_nodes, n_points = 1, n_own = 3 * Geometry::n_modes;

  static Lanes volume(const NodeVectors<n_nodes>& nodal_x) {
    const BaseVectors<Geometry> x = base_sums<Geometry>(nodal_x);
    return dot(Geometry::volume_gradient(x)[0], x[0]);
  }
  /// As advance_uniform_gradient.
  ///   state  [6 + material + n_own]
  static void advance(const ElementProperties& properties, const SolidMotion<n_nodes>& motion,
                      std::span<Lanes> state, SolidStep<n_nodes>& step) {
    const std::size_t point = state.size() - n_own;
    advance_uniform_gradient<Geometry>(properties, motion, state.first(point), state.subspan(point), step);
  }
};

}  // namespace contactsim
