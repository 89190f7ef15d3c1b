// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/materials/material_row.hpp"

namespace contactsim {

/// Hypoelastic, a law as law_kind.hpp says: the stress rate is linear in the strain rate.
/// Source: Sierra/SM, ELASTIC.
struct ElasticLaw {
  ElasticModuli moduli;
  static constexpr std::size_t n_tensors = 0, n_state = 0;
  static constexpr std::array<StateVariable, 0> variables{};
  static constexpr bool adds_stress = true;

  void start(std::span<Lanes>) const {}
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const;
};

MaterialRow elastic_material();

/// Small strain: read, but not integrated.
MaterialRow linear_elastic_material();

}  // namespace contactsim
