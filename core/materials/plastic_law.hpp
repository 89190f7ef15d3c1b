// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/materials/elastic_stress.hpp"
#include "core/materials/plane_return.hpp"
#include "core/materials/plane_step.hpp"

namespace contactsim {

/// Von Mises plasticity with associated flow, a law as law_kind.hpp says, brought back to the yield
/// surface along its radius. State: the back stress (if the hardening has one), then the equivalent plastic
/// strain. Source: Simo and Hughes, Computational Inelasticity (1998), 3.3; Wilkins, UCRL-7322 (1963).
template <class Hardening>
struct PlasticLaw {
  ElasticModuli moduli;
  Hardening hardening;
  static constexpr std::size_t n_tensors = Hardening::has_back_stress ? 1 : 0;
  static constexpr std::size_t n_state = 6 * n_tensors + 1;
  static constexpr std::array variables = Hardening::variables;

  void start(std::span<Lanes> state) const {
    for (Lanes& number : state) number.setZero();
  }
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const;
};

template <class Hardening>
LaneModuli PlasticLaw<Hardening>::update(const StrainStep& step, SymmetricLanes& stress,
                                         std::span<Lanes> state) const {
  stress = elastic_stress(moduli, step.strain, stress);
  SymmetricLanes relative = deviator(stress);  // to the back stress
  if constexpr (Hardening::has_back_stress) {
    for (std::size_t i = 0; i < 6; ++i) relative[i] -= state[i];
  }
  Lanes& eqps = state[n_state - 1];
  const Lanes trial = (1.5 * contract(relative, relative)).sqrt();
  const auto flown = return_to(hardening, SolidTrial{trial, eqps, moduli.shear, step.dt});
  if (!flown) return bounds_of(moduli);
  const auto& [increment, kinematic] = *flown;
  const Lanes per_trial = (increment > 0.0).select(increment / trial, 0.0);
  for (std::size_t i = 0; i < 6; ++i) {
    const Lanes flow = per_trial * relative[i];
    stress[i] -= 3.0 * moduli.shear * flow;
    if constexpr (Hardening::has_back_stress) state[i] += kinematic * flow;
  }
  eqps += increment;
  return bounds_of(moduli);
}

template <class Hardening>
void PlasticLaw<Hardening>::update_plane(const PlaneStep& step, PlaneLanes& stress,
                                         std::span<Lanes> state) const {
  const PlaneModuli plane(moduli);
  plane.add(step.strain, stress);
  PlaneLanes relative = stress;  // to the back stress less its part along the normal
  if constexpr (Hardening::has_back_stress) {
    for (std::size_t i = 0; i < 5; ++i)
      relative[i] -= state[plane_places[i]] - (i < 2 ? state[2] : Lanes::Zero());
  }
  Lanes& eqps = state[n_state - 1];
  const Lanes sum = relative[0] + relative[1], difference = relative[0] - relative[1];
  const Lanes shears = relative[2] * relative[2] + relative[3] * relative[3] + relative[4] * relative[4];
  const PlaneTrial trial{0.25 * sum * sum,
                         0.75 * difference * difference + 3.0 * shears,
                         (plane.direct + plane.across) / 3.0,
                         2.0 * plane.shear,
                         eqps,
                         step.dt};
  const auto flown = return_to(hardening, trial);
  if (!flown) return;
  const auto& [flow, increment, kinematic] = *flown;
  const Lanes new_sum = sum / (1.0 + (trial.a + kinematic) * flow);
  const Lanes per_flow = 1.0 / (1.0 + (trial.b + kinematic) * flow), new_difference = difference * per_flow;
  const PlaneLanes end{0.5 * (new_sum + new_difference), 0.5 * (new_sum - new_difference),
                       relative[2] * per_flow, relative[3] * per_flow, relative[4] * per_flow};
  for (std::size_t i = 0; i < 5; ++i) stress[i] += end[i] * (1.0 + kinematic * flow) - relative[i];
  if constexpr (Hardening::has_back_stress) {
    const Lanes mean = new_sum / 3.0;
    for (std::size_t i = 0; i < 5; ++i)
      state[plane_places[i]] += kinematic * flow * (end[i] - (i < 2 ? mean : Lanes::Zero()));
    state[2] -= kinematic * flow * mean;
  }
  eqps += increment;
}

template <class Hardening>
void PlasticLaw<Hardening>::update_fibre(const FibreStep& step, FibreLanes& stress,
                                         std::span<Lanes> state) const {
  stress[0] += moduli.youngs() * step.strain[0];
  for (std::size_t i = 1; i < 3; ++i) stress[i] += moduli.shear * step.strain[i];
  FibreLanes relative = stress;  // to the back stress less its parts across
  if constexpr (Hardening::has_back_stress) {
    relative[0] -= 1.5 * state[0];
    for (std::size_t i = 1; i < 3; ++i) relative[i] -= state[fibre_places[i]];
  }
  Lanes& eqps = state[n_state - 1];
  const PlaneTrial trial{relative[0] * relative[0],
                         3.0 * (relative[1] * relative[1] + relative[2] * relative[2]),
                         2.0 / 3.0 * moduli.youngs(),
                         2.0 * moduli.shear,
                         eqps,
                         step.dt};
  const auto flown = return_to(hardening, trial);
  if (!flown) return;
  const auto& [flow, increment, kinematic] = *flown;
  const Lanes per_shear = 1.0 / (1.0 + (trial.b + kinematic) * flow);
  const FibreLanes end{relative[0] / (1.0 + (trial.a + kinematic) * flow), relative[1] * per_shear,
                       relative[2] * per_shear};
  for (std::size_t i = 0; i < 3; ++i) stress[i] += end[i] * (1.0 + kinematic * flow) - relative[i];
  if constexpr (Hardening::has_back_stress) {
    const Lanes across = kinematic * flow * end[0] / 3.0;
    state[0] += 2.0 * across;
    state[1] -= across;
    state[2] -= across;
    for (std::size_t i = 1; i < 3; ++i) state[fibre_places[i]] += kinematic * flow * end[i];
  }
  eqps += increment;
}

}  // namespace contactsim
