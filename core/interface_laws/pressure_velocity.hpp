// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// Friction by pressure p and slip rate v. The tangential traction is at most
/// mu(v) * ((p + offset) / reference)^exponent, mu(v) = mu_d + (mu_s - mu_d) exp(-decay * v): the
/// coefficients are the tractions at p + offset = reference. Coulomb's law has reference 1, offset 0 and
/// exponent 1.
struct PressureVelocityFriction {
  double static_coefficient = 0.0;   ///< mu_s >= 0, at rest [force/length^2]
  double dynamic_coefficient = 0.0;  ///< mu_d >= 0, fast [force/length^2]
  double velocity_decay = 0.0;       ///< >= 0 [time/length]
  double reference_pressure = 1.0;   ///< > 0 [force/length^2]
  double offset_pressure = 0.0;      ///< >= 0 [force/length^2]
  double pressure_exponent = 1.0;    ///< [1]

  /// As SlipLimit.
  double operator()(double force, double area, double speed) const {
    const double coefficient =
        dynamic_coefficient + (static_coefficient - dynamic_coefficient) * std::exp(-velocity_decay * speed);
    const double pressure = std::max(force / area + offset_pressure, 0.0) / reference_pressure;
    return coefficient * std::pow(pressure, pressure_exponent) * area;
  }
};

/// PV_DEPENDENT MODEL.
inline InterfaceLawRow pressure_velocity() {
  InterfaceLawRow row{
      "pv dependent",
      "Coefficient by pressure and slip rate",
      {
          parameter::non_negative("static coefficient", "Coefficient at rest [1]").otherwise(0.0),
          parameter::non_negative("dynamic coefficient", "Coefficient at high slip rate [1]").otherwise(0.0),
          parameter::non_negative("velocity decay",
                                  "How fast the coefficient falls with the slip rate [time/length]")
              .otherwise(0.0),
          parameter::positive("reference pressure",
                              "Pressure that the sum of pressure and offset is measured by; at 1, with the "
                              "defaults of the rest, the coefficients are Coulomb's [force/length^2]")
              .otherwise(1.0),
          parameter::non_negative("offset pressure", "Added to the pressure [force/length^2]").otherwise(0.0),
          parameter::real("pressure exponent", "Power of the relative pressure [1]").otherwise(1.0),
      }};
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    const auto real = [&](const char* phrase) { return input.values.real(phrase); };
    InterfaceLaw law;
    law.friction = 1.0;
    law.limit = PressureVelocityFriction{real("static coefficient"), real("dynamic coefficient"),
                                         real("velocity decay"),     real("reference pressure"),
                                         real("offset pressure"),    real("pressure exponent")};
    return law;
  };
  return row;
}

}  // namespace contactsim
