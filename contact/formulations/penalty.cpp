// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/penalty.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// From which penetration, over the thickness of the thinner element, the penalty gets stiffer, from which on
/// it does so no more, and how many times as stiff it is then. The largest pressure that a column bears, E
/// times 0.3 of strain, presses it in by an eighth of its elements so; a spring alone would let it through.
constexpr double first_share = 0.05, last_share = 0.25, stiffest = 100.0;

/// What is left of two things in series, such as springs.
double in_series(double a, double b) { return a * b / (a + b); }

/// The same of a property of two sides of which a rigid one has an infinite one; of two rigid ones their own.
double of_sides(const PenaltyProperties& first, const PenaltyProperties* second,
                double PenaltyProperties::*property) {
  if (second == nullptr || (second->is_rigid && !first.is_rigid)) return first.*property;
  if (first.is_rigid && !second->is_rigid) return second->*property;
  return in_series(first.*property, second->*property);
}

}  // namespace

double stiffness_of_sides(const PenaltyProperties& first, const PenaltyProperties* second) {
  return of_sides(first, second, &PenaltyProperties::stiffness);
}

PairPenalty make_pair_penalty(const PenaltyProperties& first, const PenaltyProperties* second,
                              const SurfacePair& pair) {
  // Of the thinner element. What is right in its middle, such as a sheet that stands on another's, is on
  // neither side of it.
  constexpr double deep = 0.5 * (1.0 - 1e-6);
  // Where one side of a shell alone takes part, nothing comes near its other one.
  const double share = pair.is_polar() ? 1.0 : deep;
  PairPenalty penalty;
  penalty.stiffness = pair.penalty_stiffness.value_or(stiffness_of_sides(first, second)) * pair.penalty_scale;
  const double mass = of_sides(first, second, &PenaltyProperties::mass_per_area);
  penalty.damping = 2.0 * pair.damping_fraction * std::sqrt(penalty.stiffness * mass);
  const double thickness = second ? std::min(first.thickness, second->thickness) : first.thickness;
  penalty.depth = pair.normal_tolerance.value_or(share * thickness);
  if (!pair.penalty_stiffness) {
    const double start_depth = std::max(first.start_depth, second ? second->start_depth : 0.0);
    penalty.law = DepthLaw(first_share * thickness, last_share * thickness, stiffest).behind(start_depth);
  }
  return penalty;
}

PairPenalty make_pair_penalty(const PenaltyProperties& first, const PenaltyProperties* second,
                              const PairRule& rule) {
  PairPenalty penalty = make_pair_penalty(first, second, *rule.pair);
  if (rule.interface_law == nullptr || !rule.interface_law->pressure) return penalty;
  penalty.pressure = &*rule.interface_law->pressure;
  if (rule.friction > 0.0) penalty.least_slope = penalty.stiffness;
  return penalty;
}

}  // namespace contactsim
