// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace contactsim {

/// PV_DEPENDENT MODEL: friction by pressure p and slip rate v. The tangential traction is at most
/// mu(v) * ((p + offset) / reference)^exponent, mu(v) = mu_d + (mu_s - mu_d) exp(-decay * v): the
/// coefficients are the tractions at p + offset = reference. Coulomb's law has reference 1, offset 0 and
/// exponent 1.
struct PressureVelocityFriction {
  double static_coefficient = 0.0;   ///< mu_s >= 0, at rest [force/length^2]
  double dynamic_coefficient = 0.0;  ///< mu_d >= 0, fast [force/length^2]
  double velocity_decay = 0.0;       ///< >= 0 [time/length]
  double reference_pressure = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force/length^2]
  double offset_pressure = 0.0;                                          ///< >= 0 [force/length^2]
  double pressure_exponent = 1.0;                                        ///< [1]
  bool operator==(const PressureVelocityFriction&) const = default;
};

}  // namespace contactsim
