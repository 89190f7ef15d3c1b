// SPDX-License-Identifier: BSD-3-Clause
#include "contact/place_law.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

double PlaceLaw::reach() const {
  double reach = pull ? pull->last() : 0.0;
  if (rate_limit) reach = std::max(reach, rate_limit->cutoff);
  return reach;
}

double PlaceLaw::slip_limit(double force, double area, double speed) const {
  if (!pressure_velocity) return friction * force;
  const PressureVelocityFriction& pv = *pressure_velocity;
  const double coefficient = pv.dynamic_coefficient + (pv.static_coefficient - pv.dynamic_coefficient) *
                                                          std::exp(-pv.velocity_decay * speed);
  const double pressure = std::max(force / area + pv.offset_pressure, 0.0) / pv.reference_pressure;
  return coefficient * std::pow(pressure, pv.pressure_exponent) * area;
}

}  // namespace contactsim
