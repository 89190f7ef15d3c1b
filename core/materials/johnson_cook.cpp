// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/johnson_cook.hpp"

#include <stdexcept>

namespace contactsim {

template struct PlasticLaw<JohnsonCookHardening>;

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

std::vector<Parameter> johnson_cook_parameters() {
  return joined({
      {parameter::positive("yield stress", "Static yield stress [force/length^2]").required()},
      power_parameters(),
      {
          parameter::non_negative("rate constant", "Factor of the logarithm of the rate [1]").otherwise(0.0),
          parameter::positive("reference rate", "Strain rate of the static curve [1/time]")
              .otherwise(1.0)
              .or_spelled("edot ref"),
          parameter::real("d1", "Failure strain: constant part [1]"),
          parameter::real("d2", "Failure strain: factor of the exponential [1]"),
          parameter::real("d3", "Failure strain: factor of the triaxiality [1]"),
          parameter::real("d4", "Failure strain: factor of the logarithm of the rate [1]"),
          parameter::real("d5", "Failure strain: factor of the temperature [1]"),
      },
  });
}

std::optional<MaterialLaw> make_johnson_cook_law(const MaterialInput& input) {
  const ParameterValues& values = input.values;
  const PowerHardening power{values.real("yield stress"), values.real("hardening constant"),
                             values.real("hardening exponent")};
  const double reference_rate = values.real("reference rate");
  const PlasticLaw<JohnsonCookHardening> plastic{input.moduli(),
                                                 {power, values.real("rate constant"), reference_rate}};
  const auto d1 = values.find_real("d1"), d2 = values.find_real("d2"), d3 = values.find_real("d3"),
             d4 = values.find_real("d4");
  // Without temperature the factor of d5 is 1.
  if (!d1 && !d2 && !d3 && !d4) return plastic;
  const JohnsonCookFailure failure{d1.value_or(0.0), d2.value_or(0.0), d3.value_or(0.0), d4.value_or(0.0),
                                   reference_rate};
  if (!(failure.strain(Lanes::Zero(), Lanes::Zero())(0) > 0.0))
    throw std::invalid_argument("d1 + d2, the failure strain in shear, must be positive");
  return FailingJohnsonCookLaw{plastic, failure};
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

MaterialRow johnson_cook_material() {
  return {{"johnson_cook"},
          "Plasticity with rate dependence and failure strain",
          johnson_cook_parameters(),
          {&law_kind<PlasticLaw<JohnsonCookHardening>>, &law_kind<FailingJohnsonCookLaw>},
          make_johnson_cook_law};
}

}  // namespace contactsim
