// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/laws.hpp"

#include <algorithm>

#include "core/materials/plastic_return.hpp"

namespace contactsim {

namespace {

/// The stress at the end of a step that is elastic.
SymmetricLanes elastic_stress(const ElasticModuli& moduli, const SymmetricLanes& strain,
                              const SymmetricLanes& stress) {
  const Lanes volumetric = moduli.lambda() * trace(strain);
  SymmetricLanes trial;
  for (std::size_t i = 0; i < 6; ++i) trial[i] = stress[i] + 2.0 * moduli.shear * strain[i];
  for (std::size_t i = 0; i < 3; ++i) trial[i] += volumetric;
  return trial;
}

LaneModuli bounds_of(const ElasticModuli& moduli) {
  return {Lanes::Constant(std::max(moduli.bulk, 2.0 / 3.0 * moduli.shear)), Lanes::Constant(moduli.shear)};
}

/// What the plastic increment x of a step must satisfy: trial - stiffness x = flow stress(x).
template <class Hardening>
struct Consistency {
  const Hardening& hardening;
  Lanes trial;       ///< equivalent stress were the step elastic [force/length^2]
  Lanes eqps;        ///< equivalent plastic strain at the start [1]
  double stiffness;  ///< by how much the equivalent stress falls per plastic increment [force/length^2]
  double dt;         ///< [time]

  /// Zero where the step is elastic. The residual falls with x, so the root lies between 0 and the x that the
  /// least hardening would give; Newton's steps that leave the bracket are replaced by halving it.
  Lanes solve() const {
    constexpr double tolerance = 1e-12;  // of the trial stress
    constexpr int max_iterations = 100;
    const FlowStress start = hardening.at(eqps, Lanes::Zero(), dt);
    const Lanes excess = (trial - start.value).max(0.0);
    Lanes low = Lanes::Zero(), high = excess / (stiffness + hardening.min_slope());
    Lanes x = high;
    for (int i = 0; i < max_iterations; ++i) {
      const FlowStress flow = hardening.at(eqps, x, dt);
      const Lanes residual = trial - stiffness * x - flow.value;
      const LaneMask is_done = excess <= 0.0 || residual.abs() <= tolerance * trial;
      if (is_done.all()) break;
      low = (residual > 0.0).select(x, low);
      high = (residual > 0.0).select(high, x);
      const Lanes newton = x + residual / (stiffness + flow.slope);
      const LaneMask is_inside = newton > low && newton < high;
      x = is_done.select(x, is_inside.select(newton, 0.5 * (low + high)));
    }
    return x;
  }
};

/// Nothing where all lanes are elastic.
template <class Hardening>
std::optional<PlasticFlow<double>> return_to(const Hardening& hardening, const SolidTrial& trial) {
  const double dt = trial.dt;
  // Without a step nothing flows, although a flow stress that was raised by its rate falls back.
  if (dt == 0.0 || (trial.equivalent <= hardening.at(trial.eqps, Lanes::Zero(), dt).value).all())
    return std::nullopt;
  const double stiffness = 3.0 * trial.shear + hardening.kinematic_modulus;
  const Consistency<Hardening> consistency{hardening, trial.equivalent, trial.eqps, stiffness, dt};
  return PlasticFlow<double>{consistency.solve(), hardening.kinematic_modulus};
}

}  // namespace

LaneModuli ElasticLaw::update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes>) const {
  stress = elastic_stress(moduli, step.strain, stress);
  return bounds_of(moduli);
}

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

template struct PlasticLaw<LinearHardening>;
template struct PlasticLaw<PowerHardening>;
template struct PlasticLaw<JohnsonCookHardening>;
template struct PlasticLaw<MultilinearHardening>;
template struct PlasticLaw<VoceHardening>;

}  // namespace contactsim
