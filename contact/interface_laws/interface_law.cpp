// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/interface_law.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

double InterfaceLaw::activation_distance() const {
  double activation_distance = pull ? pull->last() : 0.0;
  if (rate_limit) activation_distance = std::max(activation_distance, rate_limit->cutoff);
  return activation_distance;
}

double InterfaceLaw::slip_limit(double force, double area, double speed) const {
  if (!pressure_velocity) return friction * force;
  const PressureVelocityFriction& pv = *pressure_velocity;
  const double coefficient = pv.dynamic_coefficient + (pv.static_coefficient - pv.dynamic_coefficient) *
                                                          std::exp(-pv.velocity_decay * speed);
  const double pressure = std::max(force / area + pv.offset_pressure, 0.0) / pv.reference_pressure;
  return coefficient * std::pow(pressure, pv.pressure_exponent) * area;
}

}  // namespace contactsim
