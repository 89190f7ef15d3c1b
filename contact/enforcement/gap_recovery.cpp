// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/gap_recovery.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// The share of a penetration that comes out in a step, and the most over the thickness.
constexpr double gap_recovery = 0.2, fastest_recovery = 2e-4;

/// How far a point may penetrate at the end of a step [length].
double left_penetration(double gap, double thickness) {
  return std::max({0.0, -(1.0 - gap_recovery) * gap, -gap - fastest_recovery * thickness});
}

}  // namespace

double left_gap(double gap, bool pulls, double thickness) {
  return pulls && gap > 0.0 ? left_penetration(-gap, thickness) : -left_penetration(gap, thickness);
}

}  // namespace contactsim
