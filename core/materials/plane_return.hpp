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

  /// Zero where the step is elastic; nothing where all of it is.
  std::optional<PlaneFlow<double>> solve() const {
    // Without a step nothing flows, although a flow stress that was raised by its rate falls back.
    if (dt == 0.0) return std::nullopt;
    const Lanes trial = (sum_part + difference_part).sqrt();
    const FlowStress start = hardening.at(eqps, Lanes::Zero(), dt);
    const LaneMask flows = trial > start.value;
    if (!flows.any()) return std::nullopt;
    return solve(trial, start, flows);
  }

 private:
  /// The equivalent stress q after a flow, and by how much its square falls, -q dq/dg.
  struct Fallen {
    Lanes equivalent, fall;
  };

  Fallen fallen(const Lanes& g) const {
    const Lanes by_a = 1.0 + a * g, by_b = 1.0 + b * g, ratio = 1.0 / (by_a * by_b);
    const Lanes ra = ratio * by_b, rb = ratio * by_a;
    const Lanes sum = sum_part * ra * ra, difference = difference_part * rb * rb;
    return {(sum + difference).sqrt(), a * sum * ra + b * difference * rb};
  }

  /// A flow that is too large: q falls at least as 1 / (1 + least g), and the flow stress at most to that of
  /// the largest plastic strain that an endless flow would give.
  Lanes upper_bound(const Lanes& trial, const Lanes& start) const {
    constexpr double smallest = 1e-12;  // of the trial stress, the accuracy of the solution
    Lanes min_flow = start;
    if (hardening.min_slope() < 0.0) {
      const Lanes max_strain = 2.0 / 3.0 * (sum_part / (a * a) + difference_part / (b * b)).sqrt();
      min_flow += hardening.min_slope() * max_strain;
    }
    return ((trial / min_flow.max(smallest * trial) - 1.0) / std::min(a, b)).max(0.0);
  }

  /// The flow of a stress all of which falls as fast as it does at first, with the hardening of the start:
  /// off by the square of the step.
  Lanes radial_guess(const Lanes& trial, const FlowStress& start) const {
    const Lanes square = sum_part + difference_part, fall = a * sum_part + b * difference_part;
    return (trial - start.value) * square / (fall * start.value + 2.0 / 3.0 * start.slope * square * trial);
  }

  /// Newton's steps that leave the bracket are replaced by halving it.
  PlaneFlow<double> solve(const Lanes& trial, const FlowStress& start, const LaneMask& flows) const {
    constexpr double tolerance = 1e-12;  // of the trial stress
    constexpr int max_iterations = 200;
    Lanes low = Lanes::Zero(), high = upper_bound(trial, start.value);
    Lanes g = radial_guess(trial, start);
    g = flows.select((g > low && g < high).select(g, high), 0.0);
    Lanes increment = Lanes::Zero();
    for (int i = 0; i < max_iterations; ++i) {
      const auto [q, fall] = fallen(g);
      increment = 2.0 / 3.0 * g * q;
      const FlowStress flow = hardening.at(eqps, increment, dt);
      const Lanes residual = q - flow.value;
      const LaneMask is_done = !flows || residual.abs() <= tolerance * trial;
      if (is_done.all()) break;
      low = (residual > 0.0).select(g, low);
      high = (residual > 0.0).select(high, g);
      // dq/dg = -fall / q, and the flow stress grows with 2/3 (q + g dq/dg).
      const Lanes newton = g + residual * q / (fall + 2.0 / 3.0 * flow.slope * (q * q - g * fall));
      const LaneMask is_inside = newton > low && newton < high;
      g = is_done.select(g, is_inside.select(newton, 0.5 * (low + high)));
    }
    return {g, increment, kinematic};
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
