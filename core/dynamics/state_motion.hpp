// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/state.hpp"
#include "core/elements/force_term.hpp"

namespace contactsim {

/// The motion of a state, which must outlive it.
///   dt  of the step that ended there [time]
inline Motion motion_of(const State& state, double dt) {
  Motion motion{state.time, dt, state.coordinates, state.velocity};
  if (state.rotations.exist()) motion.angular_velocity = &state.rotations.velocity;
  return motion;
}
inline Motion motion_of(const State& state) { return motion_of(state, state.dt); }

}  // namespace contactsim
