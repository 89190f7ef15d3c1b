// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/power_hardening.hpp"

namespace contactsim {

/// Flow stress that grows with a power of the plastic strain and the logarithm of its rate; rates below the
/// reference count as the reference. Source: Johnson and Cook, 7th Int. Symp. on Ballistics (1983) 541-547,
/// without temperature.
struct JohnsonCookHardening {
  PowerHardening power;         ///< with no Lueders strain
  double rate_constant = 0.0;   ///< >= 0 [1]
  double reference_rate = 1.0;  ///< > 0 [1/time]
  static constexpr bool has_back_stress = false;
  static constexpr std::array variables = plastic_strain_only;
  static constexpr double kinematic_modulus = 0.0;

  FlowStress at(const Lanes& eqps, const Lanes& increment, double dt) const {
    const FlowStress slow = power.at(eqps, increment, dt);
    const Lanes rate = increment / (dt * reference_rate);
    const LaneMask is_fast = rate > 1.0;
    const Lanes factor = 1.0 + rate_constant * rate.max(1.0).log();
    const Lanes factor_slope = is_fast.select(rate_constant / increment, 0.0);
    return {slow.value * factor, slow.slope * factor + slow.value * factor_slope};
  }
  double min_slope() const { return 0.0; }
};

extern template struct PlasticLaw<JohnsonCookHardening>;

/// The plastic strain at which a material breaks while it flows,
///   (d1 + d2 exp(d3 mean stress / von Mises stress)) (1 + d4 ln(rate / reference rate)),
/// rates below the reference counting as the reference, without temperature.
/// Source: Johnson and Cook, Eng. Fract. Mech. 21 (1985) 31-48, eq. 6.
struct JohnsonCookFailure {
  double d1 = 0.0, d2 = 0.0, d3 = 0.0, d4 = 0.0;  ///< [1]
  double reference_rate = 1.0;                    ///< > 0 [1/time]

  ///   triaxiality  mean over von Mises stress [1]
  ///   rate         of the plastic strain [1/time]
  Lanes strain(const Lanes& triaxiality, const Lanes& rate) const {
    return (d1 + d2 * (d3 * triaxiality).exp()) * (1.0 + d4 * (rate / reference_rate).max(1.0).log());
  }
};

/// Johnson-Cook plasticity that counts damage, a law as law_kind.hpp says: it grows by the plastic strain
/// over that at which the material would break in the present stress. Where it has reached 1 the law has
/// failed; the stress stays as it is until the element dies.
struct FailingJohnsonCookLaw : PlasticLaw<JohnsonCookHardening> {
  JohnsonCookFailure failure_strain;
  static constexpr std::size_t n_state = 2;
  static constexpr std::array variables{
      StateVariable{"eqps", 0, 1, "equivalent plastic strain [1]"},
      StateVariable{"damage", 1, 1, "share of the plastic strain to failure, 1 at failure [1]"}};
  static constexpr std::string_view failure = "damage";

  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const;
};

/// JOHNSON_COOK, without temperature; it fails when one of D1 to D4 is given.
MaterialRow johnson_cook_material();

}  // namespace contactsim
