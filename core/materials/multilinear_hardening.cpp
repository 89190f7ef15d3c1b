// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/multilinear_hardening.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace contactsim {

namespace {

/// Growth of the back stress by the plastic increment in a step that has taken the curve up by `growth`.
Lanes kinematic_modulus(const MultilinearHardening& hardening, const Lanes& growth, const Lanes& increment) {
  return (increment > 0.0).select((1.0 - hardening.beta) * growth / increment, 0.0);
}

/// The yield condition of a shell or a fibre along the curve.
struct YieldCondition {
  const PlaneTrial& trial;
  Lanes start_radius;  ///< of the yield surface [force/length^2]
  Lanes start_stress;  ///< on the curve [force/length^2]

  /// Denominators at a plastic increment and a stress of the curve.
  Lanes sum_at(const Lanes& increment, const Lanes& stress) const {
    return start_radius + (stress - start_stress) + 1.5 * trial.a * increment;
  }
  Lanes difference_at(const Lanes& increment, const Lanes& stress) const {
    return start_radius + (stress - start_stress) + 1.5 * trial.b * increment;
  }

  LaneMask is_beyond(const HardeningCurve::Point& point) const {
    const Lanes increment = point.strain - trial.eqps, stress = Lanes::Constant(point.stress);
    const Lanes sum = sum_at(increment, stress), difference = difference_at(increment, stress);
    return trial.sum_part / (sum * sum) + trial.difference_part / (difference * difference) >= 1.0;
  }

  /// How far lanes that are not elastic go on from a place of the curve [1].
  Lanes rest_from(const HardeningCurve::Place& place) const {
    constexpr int max_iterations = 50;  // a few do
    const Lanes passed = place.strain - trial.eqps;
    const Lanes sum_start = sum_at(passed, place.stress);
    const Lanes difference_start = difference_at(passed, place.stress);
    const Lanes sum_slope = place.slope + 1.5 * trial.a, difference_slope = place.slope + 1.5 * trial.b;
    Lanes rest = Lanes::Zero();
    for (int i = 0; i < max_iterations; ++i) {
      const Lanes sum = 1.0 / (sum_start + sum_slope * rest);
      const Lanes difference = 1.0 / (difference_start + difference_slope * rest);
      const Lanes sum_square = trial.sum_part * sum * sum;
      const Lanes difference_square = trial.difference_part * difference * difference;
      const Lanes total = sum_square + difference_square;
      const Lanes fall = sum_square * sum * sum_slope + difference_square * difference * difference_slope;
      const Lanes next = rest + (total > 1.0).select(total * (total.sqrt() - 1.0) / fall, 0.0);
      if ((next <= rest).all()) break;
      rest = next;
    }
    return rest;
  }
};

}  // namespace

std::optional<PlasticFlow<Lanes>> return_to(const MultilinearHardening& hardening, const SolidTrial& trial) {
  const HardeningCurve::Place start = hardening.curve.at(trial.eqps);
  const Lanes excess = trial.equivalent - hardening.radius(start.stress);
  if (trial.dt == 0.0 || (excess <= 0.0).all()) return std::nullopt;
  const double fall = 3.0 * trial.shear;
  const auto left_at = [&](const auto& strain, const auto& stress) -> Lanes {
    return excess - fall * (strain - trial.eqps) - (stress - start.stress);
  };
  const auto end = hardening.curve.climb(start, [&](const HardeningCurve::Point& point) -> LaneMask {
    return left_at(point.strain, point.stress) >= 0.0;
  });
  const Lanes rest = left_at(end.strain, end.stress).max(0.0) / (fall + end.slope);
  const Lanes increment = (end.strain - trial.eqps) + rest;
  const Lanes growth = (end.stress - start.stress) + end.slope * rest;
  return PlasticFlow<Lanes>{increment, kinematic_modulus(hardening, growth, increment)};
}

std::optional<PlaneFlow<Lanes>> return_to(const MultilinearHardening& hardening, const PlaneTrial& trial) {
  const HardeningCurve::Place start = hardening.curve.at(trial.eqps);
  const Lanes radius = hardening.radius(start.stress);
  if (trial.dt == 0.0 || (trial.sum_part + trial.difference_part <= radius * radius).all())
    return std::nullopt;
  const YieldCondition condition{trial, radius, start.stress};
  const auto end = hardening.curve.climb(
      start, [&](const HardeningCurve::Point& point) { return condition.is_beyond(point); });
  const Lanes rest = condition.rest_from(end);
  const Lanes increment = (end.strain - trial.eqps) + rest;
  const Lanes growth = (end.stress - start.stress) + end.slope * rest;
  return PlaneFlow<Lanes>{1.5 * increment / (radius + hardening.beta * growth), increment,
                          2.0 / 3.0 * kinematic_modulus(hardening, growth, increment)};
}

template struct PlasticLaw<MultilinearHardening>;

std::vector<Parameter> multilinear_parameters() {
  std::vector<Parameter> lines{
      isotropic_share(),
      parameter::function("hardening function",
                          "Flow stress, or what is added to the yield stress, over the plastic strain; "
                          "piecewise linear")
          .required(),
  };
  for (const char* of : {"youngs modulus", "poissons ratio", "yield stress"})
    lines.push_back(
        parameter::ignored(fmt::format("{} function", of), "temperature has no effect on materials"));
  return lines;
}

HardeningRow multilinear_hardening() {
  return {
      "user_defined",
      {"multilinear_ep"},
      "Plasticity with hardening along a curve",
      multilinear_parameters(),
      &law_kind<PlasticLaw<MultilinearHardening>>,
      [](const MaterialInput& input) -> std::optional<MaterialLaw> { return make_multilinear_law(input); }};
}

std::optional<PlasticLaw<MultilinearHardening>> make_multilinear_law(const MaterialInput& input) {
  const ElasticModuli moduli = input.moduli();
  const double beta = input.values.real("beta");
  if (!(beta >= 0.0 && beta <= 1.0))
    throw std::invalid_argument(fmt::format("beta must be from 0 to 1, found {}", beta));
  auto curve = make_hardening_curve(input.values.name("hardening function"),
                                    input.values.real("yield stress"), input.functions, input.diagnostics);
  if (!curve) return std::nullopt;
  return PlasticLaw<MultilinearHardening>{moduli, {std::move(*curve), beta}};
}

}  // namespace contactsim
