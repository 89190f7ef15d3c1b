// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/dynamics/state.hpp"
#include "core/statics/load_steps.hpp"

namespace contactsim {

/// How equilibrium is sought, by which equation solver and why.
std::string format_load_step_search(const LoadSteps& load_steps);

/// What a factor that ranks share takes of their memory; empty of others.
std::string format_factor(const LoadSteps& load_steps);

/// The heading of the lines of load steps.
std::string load_step_heading(bool has_contact);

/// Step, time, step size, energies, iterations, forces left over as a share of their reference, cutbacks,
/// with contact the updates of its multipliers; a search or updates that were put up with are marked.
std::string format_load_step(const State& state, const LoadStepReport& report, bool has_contact);

}  // namespace contactsim
