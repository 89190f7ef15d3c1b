// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/lanes.hpp"
#include "core/elements/element_properties.hpp"

namespace contactsim {

/// Bulk viscosity: linear in the dilatation rate, and quadratic while the elements close. Its length is that
/// which a wave crosses in the undamped stable step. Source: Abaqus Theory Guide, explicit dynamic analysis.
struct BulkViscosity {
  Lanes stress;       ///< to be added to the diagonal [force/length^2]
  Lanes stable_step;  ///< the undamped one shortened by the viscosity [time]

  ///   undamped    stable step without viscosity [time]
  ///   dilatation  rate of volume change [1/time]
  ///   density     [mass/length^3]
  ///   wave_speed  of pressure [length/time]
  BulkViscosity(const ElementProperties& properties, const Lanes& undamped, const Lanes& dilatation,
                const Lanes& density, const Lanes& wave_speed) {
    const double linear = properties.linear_bulk_viscosity;
    const double quadratic = properties.quadratic_bulk_viscosity * properties.quadratic_bulk_viscosity;
    const Lanes closing = dilatation.min(0.0);
    const Lanes damping = linear - quadratic * undamped * closing;
    stable_step = undamped * ((1.0 + damping * damping).sqrt() - damping);
    const Lanes length = undamped * wave_speed;
    stress = density * length * (linear * wave_speed * dilatation - quadratic * length * closing * closing);
  }
};

}  // namespace contactsim
