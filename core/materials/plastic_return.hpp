// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/materials/flow_stress.hpp"

/// The way back to a yield surface, from where an elastic step would have ended.
namespace contactsim {

/// How a step would end were it elastic, in a solid.
struct SolidTrial {
  Lanes equivalent;   ///< stress, relative to the back stress [force/length^2]
  const Lanes& eqps;  ///< equivalent plastic strain at the start [1]
  double shear;       ///< modulus [force/length^2]
  double dt;          ///< [time]
};

/// The same in a shell or a fibre: the square of the equivalent stress in two parts, which fall by
/// 1 / (1 + a g)^2 and 1 / (1 + b g)^2 as g, the flow strain over stress, grows.
struct PlaneTrial {
  Lanes sum_part, difference_part;  ///< [force^2/length^4]
  double a, b;                      ///< > 0, without hardening [force/length^2]
  const Lanes& eqps;                ///< equivalent plastic strain at the start [1]
  double dt;                        ///< [time]
};

/// What flows in a step.
///   Modulus  double or Lanes
template <class Modulus>
struct PlasticFlow {
  Lanes increment;    ///< of the equivalent plastic strain, 0 where the step is elastic [1]
  Modulus kinematic;  ///< growth of the back stress by that [force/length^2]
};

/// The same where stresses fall at different rates.
template <class Modulus>
struct PlaneFlow {
  Lanes flow;         ///< strain over stress [length^2/force]
  Lanes increment;    ///< of the equivalent plastic strain [1]
  Modulus kinematic;  ///< growth of the back stress by the flow over the stress at the end [force/length^2]
};

/// What the plastic increment x of a step must satisfy: trial - stiffness x = flow stress(x).
template <class Hardening>
struct Consistency {
  const Hardening& hardening;
  Lanes trial;       ///< equivalent stress were the step elastic [force/length^2]
  Lanes eqps;        ///< equivalent plastic strain at the start [1]
  double stiffness;  ///< by how much the equivalent stress falls per plastic increment [force/length^2]
  double dt;         ///< [time]

  /// Zero where the step is elastic. The residual falls with x, so the root lies between 0 and the x that the
  /// least hardening would give; Newton's steps that leave the bracket are replaced by halving it. The first
  /// guess is the step with the hardening of the start, unless that is so steep that it can only be about to
  /// fall.
  ///   start  the flow stress at x = 0
  Lanes solve(const FlowStress& start) const {
    constexpr double tolerance = 1e-12;  // of the trial stress
    constexpr int max_iterations = 100;
    const double min_slope = hardening.min_slope();
    const Lanes excess = (trial - start.value).max(0.0);
    Lanes low = Lanes::Zero(), high = excess / (stiffness + min_slope);
    const Lanes slope = (start.slope < stiffness).select(start.slope, min_slope);
    Lanes x = excess / (stiffness + slope.max(min_slope));
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
  if (dt == 0.0) return std::nullopt;
  const FlowStress start = hardening.at(trial.eqps, Lanes::Zero(), dt);
  if ((trial.equivalent <= start.value).all()) return std::nullopt;
  const double stiffness = 3.0 * trial.shear + hardening.kinematic_modulus;
  const Consistency<Hardening> consistency{hardening, trial.equivalent, trial.eqps, stiffness, dt};
  return PlasticFlow<double>{consistency.solve(start), hardening.kinematic_modulus};
}

}  // namespace contactsim
