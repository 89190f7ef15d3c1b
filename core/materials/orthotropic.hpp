// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "core/definition/material_models.hpp"
#include "core/materials/elastic_moduli.hpp"
#include "core/materials/plane_step.hpp"
#include "core/materials/state_variable.hpp"
#include "core/materials/strain_step.hpp"

namespace contactsim {

/// Hypoelastic with three planes of symmetry, a law as laws.hpp says: the stress rate is linear in the strain
/// rate, by moduli along directions that turn with the material. State: the directions 1 and 2.
/// Source: Sierra/SM, ELASTIC_ORTHOTROPIC; Lekhnitskii, Theory of Elasticity of an Anisotropic Body, 1.
struct OrthotropicLaw {
  ElasticModuli moduli;  ///< of an isotropic material that is alike, for what resists hourglasses and contact
  ElasticModuli bounds;  ///< that bound the stiffness as LaneModuli; lambda >= 0
  std::array<std::array<double, 3>, 3> direct;  ///< stress along i by strain along j [force/length^2]
  std::array<double, 3> shear;                  ///< of 12, 23, 13 [force/length^2]
  std::array<double, 3> plane;                  ///< without stress along 3: 11, 22, 12 [force/length^2]
  double plane_ratio = 1.0;                     ///< bound of the plane's stiffness by that of `moduli` [1]
  static constexpr std::size_t n_tensors = 0, n_vectors = 2, n_state = 6;
  static constexpr std::array<StateVariable, 0> variables{};

  /// The directions of the coordinates.
  void start(std::span<Lanes> state) const;
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  Lanes plane_stiffening(std::span<const Lanes>) const { return Lanes::Constant(plane_ratio); }
};

/// The law of a model; without two elastic constants the isotropic material that is alike is the Voigt mean.
/// Throws std::invalid_argument, with a text for the user, when the constants give no stable material: a
/// modulus is not positive, or Poisson's ratios are so large that a strain would set energy free.
OrthotropicLaw make_orthotropic_law(const OrthotropicModel& model);

}  // namespace contactsim
