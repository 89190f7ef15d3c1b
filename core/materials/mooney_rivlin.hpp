// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/materials/hyperelastic.hpp"
#include "core/materials/material_row.hpp"

namespace contactsim {

/// Compressible Mooney-Rivlin, a law as law_kind.hpp says: the stress follows from the deformation alone,
/// with the strain energy
///   c10 (J^(-2/3) I1 - 3) + c01 (J^(-4/3) I2 - 3) + bulk/4 (J^2 - 1) - bulk/2 ln J  [energy/length^3 at
/// rest], I1 and I2 the invariants of the left Cauchy-Green tensor B, the state. Without c01 it is
/// NeoHookeanLaw. Source: Sierra/SM, MOONEY_RIVLIN; Rivlin, Phil. Trans. R. Soc. A 241 (1948) 379-397.
struct MooneyRivlinLaw {
  ElasticModuli moduli;  ///< the shear modulus is 2 (c10 + c01)
  double c01 = 0.0;      ///< [force/length^2]
  static constexpr std::size_t n_tensors = 0, n_state = 6;
  static constexpr std::array variables{
      StateVariable{"left_cauchy_green", 0, 6, "left Cauchy-Green tensor of the deformation [1]"}};

  double c10() const { return 0.5 * moduli.shear - c01; }
  ///   b  left Cauchy-Green tensor [1]
  hyperelastic::Response at(const SymmetricLanes& b) const;
  void start(std::span<Lanes> state) const;
  /// The bounds returned hold for the tangent of Cauchy stress and for the share of the stress itself.
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  Lanes plane_thinning(std::span<const Lanes> state) const { return state[2].sqrt(); }
  Lanes plane_stiffening(std::span<const Lanes> state) const;
};

/// MOONEY_RIVLIN, by C10, C01 and one elastic constant; a second one is compared.
MaterialRow mooney_rivlin_material();

}  // namespace contactsim
