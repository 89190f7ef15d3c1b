// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/materials/material_row.hpp"

namespace contactsim {

/// Compressible neo-Hookean, a law as law_kind.hpp says: the stress follows from the deformation alone,
/// with the strain energy
///   bulk/4 (J^2 - 1) - bulk/2 ln J + shear/2 (J^(-2/3) tr B - 3)   [energy/length^3 at rest].
/// State: the left Cauchy-Green tensor B, of which every step makes f B f^T with the step's own deformation
/// gradient f; the step's rotation is a part of f, so B is not turned besides.
/// Source: Sierra/SM, NEO_HOOKEAN; Simo and Hughes, Computational Inelasticity (1998), 9.2.
struct NeoHookeanLaw {
  ElasticModuli moduli;
  static constexpr std::size_t n_tensors = 0, n_state = 6;
  static constexpr std::array variables{
      StateVariable{"left_cauchy_green", 0, 6, "left Cauchy-Green tensor of the deformation [1]"}};

  void start(std::span<Lanes> state) const;
  /// The bounds returned hold for the tangent of Cauchy stress and for the share of the stress itself.
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const;
  Lanes plane_thinning(std::span<const Lanes> state) const { return state[2].sqrt(); }
  Lanes plane_stiffening(std::span<const Lanes> state) const;
  Lanes fibre_thinning(std::span<const Lanes> state) const { return state[1]; }
  Lanes fibre_stiffening(std::span<const Lanes> state) const;
};

/// NEO_HOOKEAN.
MaterialRow neo_hookean_material();

}  // namespace contactsim
