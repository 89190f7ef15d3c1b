// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>

#include "core/materials/plastic_return.hpp"

/// The way back to a yield surface in a shell or a fibre, where stresses fall at different rates.
namespace contactsim {

/// What the flow g = strain over stress of a step must satisfy in a shell or a fibre. In a shell, with s, d
/// the sum and the difference of the direct stresses and t those of shear, all relative to the back stress in
/// an elastic step:
///   q(g)^2 = s^2 / 4 / (1 + a g)^2 + (3/4 d^2 + 3 t^2) / (1 + b g)^2,  q(g) = flow stress(2/3 g q(g));
/// in a fibre with s^2 in place of s^2 / 4, the stress along it, and no d.
/// Source: Simo and Taylor, Int. J. Numer. Meth. Eng. 22 (1986) 649-670, with the shear across the thickness.
template <class Hardening>
struct PlaneConsistency {
  const Hardening& hardening;
  Lanes sum_part, difference_part;  ///< of q^2 at g = 0 [force^2/length^4]
  double a, b;                      ///< with the hardening of the back stress [force/length^2]
  const Lanes& eqps;                ///< equivalent plastic strain at the start [1]
  double dt;                        ///< [time]
  double kinematic;                 ///< what the back stress has of a and b [force/length^2]

  Lanes equivalent(const Lanes& g) const {
    const Lanes ra = 1.0 / (1.0 + a * g), rb = 1.0 / (1.0 + b * g);
    return (sum_part * ra * ra + difference_part * rb * rb).sqrt();
  }

  Lanes slope(const Lanes& g, const Lanes& q) const {
    const Lanes ra = 1.0 / (1.0 + a * g), rb = 1.0 / (1.0 + b * g);
    return -(sum_part * a * ra * ra * ra + difference_part * b * rb * rb * rb) / q;
  }

  /// A flow that is too large: q falls at least as 1 / (1 + least g), and the flow stress at most to that of
  /// the largest plastic strain that an endless flow would give.
  Lanes upper_bound(const Lanes& trial, const Lanes& start) const {
    constexpr double smallest = 1e-12;  // of the trial stress, the accuracy of the solution
    const Lanes max_strain = 2.0 / 3.0 * (sum_part / (a * a) + difference_part / (b * b)).sqrt();
    const Lanes min_flow = (start + std::min(0.0, hardening.min_slope()) * max_strain).max(smallest * trial);
    return ((trial / min_flow - 1.0) / std::min(a, b)).max(0.0);
  }

  /// Zero where the step is elastic; nothing where all of it is.
  std::optional<PlaneFlow<double>> solve() const {
    const Lanes trial = (sum_part + difference_part).sqrt();
    const Lanes start = hardening.at(eqps, Lanes::Zero(), dt).value;
    // Without a step nothing flows, although a flow stress that was raised by its rate falls back.
    if (dt == 0.0 || (trial <= start).all()) return std::nullopt;
    const Lanes flow = solve(trial, start);
    return PlaneFlow<double>{flow, 2.0 / 3.0 * flow * equivalent(flow), kinematic};
  }

 private:
  /// Zero where the step is elastic. Newton's steps that leave the bracket are replaced by halving it.
  Lanes solve(const Lanes& trial, const Lanes& start) const {
    constexpr double tolerance = 1e-12;  // of the trial stress
    constexpr int max_iterations = 200;
    Lanes low = Lanes::Zero(), high = upper_bound(trial, start), g = low;
    for (int i = 0; i < max_iterations; ++i) {
      const Lanes q = equivalent(g), increment = 2.0 / 3.0 * g * q;
      const FlowStress flow = hardening.at(eqps, increment, dt);
      const Lanes residual = q - flow.value;
      const LaneMask is_done = trial <= start || residual.abs() <= tolerance * trial;
      if (is_done.all()) break;
      low = (residual > 0.0).select(g, low);
      high = (residual > 0.0).select(high, g);
      const Lanes fall = slope(g, q), per_g = fall - flow.slope * (2.0 / 3.0) * (q + g * fall);
      const Lanes newton = g - residual / per_g;
      const LaneMask is_inside = newton > low && newton < high;
      g = is_done.select(g, is_inside.select(newton, 0.5 * (low + high)));
    }
    return g;
  }
};

template <class Hardening>
std::optional<PlaneFlow<double>> return_to(const Hardening& hardening, const PlaneTrial& trial) {
  const double kinematic = 2.0 / 3.0 * hardening.kinematic_modulus;
  return PlaneConsistency<Hardening>{
      hardening, trial.sum_part, trial.difference_part, trial.a + kinematic, trial.b + kinematic, trial.eqps,
      trial.dt,  kinematic}
      .solve();
}

}  // namespace contactsim
