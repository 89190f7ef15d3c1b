// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/materials/material_row.hpp"

namespace contactsim {

/// The constants of an orthotropic material. Poisson's ratio nu_ab is the contraction along b
/// under a stress along a.
struct OrthotropicConstants {
  ElasticConstants elastic;  ///< of an isotropic material that is alike; none or two
  double e11 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double e22 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double e33 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double nu12 = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double nu13 = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double nu23 = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double g12 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double g13 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
  double g23 = std::numeric_limits<double>::quiet_NaN();   ///< > 0 [force/length^2]
};

/// Hypoelastic with three planes of symmetry, a law as law_kind.hpp says: the stress rate is linear in
/// the strain rate, by moduli along directions that turn with the material. State: the directions 1 and 2.
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

/// The law of constants; without two elastic constants the isotropic material that is alike is the Voigt
/// mean. Throws std::invalid_argument, with a text for the user, when the constants give no stable material:
/// a modulus is not positive, or Poisson's ratios are so large that a strain would set energy free.
OrthotropicLaw make_orthotropic_law(const OrthotropicConstants& constants);

/// ELASTIC_ORTHOTROPIC. Its COORDINATE SYSTEM and turns are those of the state, which blocks give.
MaterialRow orthotropic_material();

}  // namespace contactsim
