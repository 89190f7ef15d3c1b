// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/failing_johnson_cook.hpp"

namespace contactsim {

namespace {

/// Damage of a step in which the plastic strain, the first of the state, has grown from `before`. A strain to
/// failure that is not positive is met at once.
///   mean, von_mises  stress [force/length^2]
void add_damage(const JohnsonCookFailure& failure, const Lanes& before, const Lanes& mean,
                const Lanes& von_mises, double dt, std::span<Lanes> state) {
  const Lanes growth = state[0] - before;
  if (!(growth > 0.0).any()) return;
  const Lanes limit = failure.strain(mean / von_mises, growth / dt);
  const Lanes damage = (limit > 0.0).select(growth / limit, 1.0);
  state[1] += (growth > 0.0).select(damage, 0.0);
}

}  // namespace

LaneModuli FailingJohnsonCookLaw::update(const StrainStep& step, SymmetricLanes& stress,
                                         std::span<Lanes> state) const {
  const Lanes before = state[0];
  const LaneModuli moduli_now = PlasticLaw::update(step, stress, state);
  const SymmetricLanes spread = deviator(stress);
  add_damage(failure_strain, before, trace(stress) / 3.0, (1.5 * contract(spread, spread)).sqrt(), step.dt,
             state);
  return moduli_now;
}

void FailingJohnsonCookLaw::update_plane(const PlaneStep& step, PlaneLanes& stress,
                                         std::span<Lanes> state) const {
  const Lanes before = state[0];
  PlasticLaw::update_plane(step, stress, state);
  const auto& [xx, yy, xy, yz, zx] = stress;
  const Lanes von_mises = (xx * xx - xx * yy + yy * yy + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt();
  add_damage(failure_strain, before, (xx + yy) / 3.0, von_mises, step.dt, state);
}

void FailingJohnsonCookLaw::update_fibre(const FibreStep& step, FibreLanes& stress,
                                         std::span<Lanes> state) const {
  const Lanes before = state[0];
  PlasticLaw::update_fibre(step, stress, state);
  const auto& [xx, xy, zx] = stress;
  const Lanes von_mises = (xx * xx + 3.0 * (xy * xy + zx * zx)).sqrt();
  add_damage(failure_strain, before, xx / 3.0, von_mises, step.dt, state);
}

}  // namespace contactsim
