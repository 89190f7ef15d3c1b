// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/model.hpp"

namespace contactsim {

/// Sets the steps that springs and dampers allow, from the masses that their ends move: those of nodes, or of
/// the rigid bodies that nodes belong to. Each is 2 / omega, or 2 / lambda of dampers, with a bound by
/// Gershgorin's circles of k_e |g_e . g_f|, g the rows of elongation by the root of the mass: all springs at
/// an end count. Ends without mass and those that are prescribed all the time do not move freely.
///   model  its masses, rigid bodies and kinematic constraints are known
void set_discrete_steps(Model& model);

/// The step that is stable with elements of a material, springs and dampers together: that of
///   (dt / material)^2 + (dt / stiffness)^2 + dt / damping = 1,
/// for the frequencies and the resistances of all sum to no more than the sum of their bounds.
///   material, stiffness, damping  that each would allow alone; infinite without any [time]
double combined_step(double material, double stiffness, double damping);

}  // namespace contactsim
