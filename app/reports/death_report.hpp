// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/run/run_death.hpp"
#include "core/definition/death.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// One report of deaths: how many; of `some` and `full` a row of every surface that has changed, faces gained
/// and lost and now owned; of `full` the ownership table of now.
///   contact  null without contact
std::string format_deaths(const DeathTally& tally, const State& state, DeathLog detail,
                          const ContactModel* contact, const Mesh& mesh);

/// How many died in the run, for its end.
std::string format_death_total(const DeathTally& tally, std::size_t n_may_die);

}  // namespace contactsim
