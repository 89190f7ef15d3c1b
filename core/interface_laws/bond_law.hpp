// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>

namespace contactsim {

/// How far two sides have moved from where they were bonded.
struct BondOpening {
  double apart = 0.0, slip = 0.0;  ///< >= 0 [length]
  double area = 0.0;     ///< of the interface [length^2]; of laws in forces its share of one bond [1]
  double penalty = 0.0;  ///< stiffest that a traction may begin with, per area [force/length^3]
};

/// What a bond answers to an opening.
struct BondForce {
  double normal = 0.0;      ///< pulls back if > 0 [force]
  double tangential = 0.0;  ///< against the slip [force]
  double stored = 0.0;      ///< [energy]
  double dissipated = 0.0;  ///< by damage in this step [energy]
  bool fails = false;
};

/// What a bond remembers.
struct BondHistory {
  double worst = 0.0;                                ///< largest lambda of a cohesive zone so far [1]
  double worst_traction = 0.0;                       ///< at that lambda [force/length^2]
  double tangential_energy = 0.0, gap_factor = 1.0;  ///< of a threaded joint in the last step
};

/// Holds what is near at the start by tractions, or forces, of its opening. In compression only slip counts:
/// contact pushes. Neither function allocates.
struct BondLaw {
  std::function<BondForce(const BondOpening& opening, BondHistory& history)> force;
  std::function<double(double penalty)> stiffness;  ///< the largest, per area, of a penalty [force/length^3]
  bool is_in_forces = false;                        ///< of one bond, not per area
};

/// A failure envelope, 1 at failure.
inline double envelope(double normal, double tangential, double exponent) {
  return std::pow(normal, exponent) + std::pow(tangential, exponent);
}

}  // namespace contactsim
