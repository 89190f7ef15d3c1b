// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/laws.hpp"

namespace contactsim {

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

/// Johnson-Cook plasticity that counts damage, a law as laws.hpp says: it grows by the plastic strain over
/// that at which the material would break in the present stress. Where it has reached 1 the law has failed;
/// the stress stays as it is until the element dies.
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

}  // namespace contactsim
