// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/multilinear_hardening.hpp"

namespace contactsim {

/// Plasticity with hardening along a curve that tears, a law as law_kind.hpp says. The tearing parameter
/// grows with the plastic strain by
///   (2 s / (3 (s - mean stress)))^4, where s, the largest principal stress, pulls.
/// When it has reached its critical value a crack begins to open, whose normal is the direction of s then.
/// All of the stress falls in proportion to the strain across the crack, at the largest so far, until nothing
/// is left; where damage has reached 1 the law has failed. Source: Wellman, SAND2012-1343; the LAME manual of
/// Sierra/SM 5.20, tearing parameter: the fall is linear and the same for all components.
struct TearingLaw : PlasticLaw<MultilinearHardening> {
  double critical_tearing = 0.0;  ///< > 0 [1]
  double critical_opening = 0.0;  ///< strain across the crack at which nothing is left, > 0 [1]
  static constexpr std::size_t n_tensors = 2, n_state = 16;
  static constexpr std::array variables{
      StateVariable{"eqps", 12, 1, "equivalent plastic strain [1]"},
      StateVariable{"tearing_parameter", 13, 1, "plastic strain, weighted by how it pulls [1]"},
      StateVariable{"crack_opening_strain", 14, 1, "strain across the crack since it began to open [1]"},
      StateVariable{"damage", 15, 1, "share of the stress that is lost, 1 at failure [1]"},
      StateVariable{"back_stress", 0, 6, "centre of the yield surface of what is whole [force/length^2]"}};
  static constexpr std::string_view failure = "damage";

  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const;
};

/// ML_EP_FAIL.
MaterialRow tearing_material();

}  // namespace contactsim
