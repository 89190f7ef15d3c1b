// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "contact/surfaces/surface_tracker.hpp"
#include "core/definition/death.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// What has died since the log last reported deaths.
struct DeathTally {
  std::size_t n_died = 0;              ///< elements
  std::size_t n_dead = 0;              ///< elements since the start
  std::size_t n_dying = 0;             ///< elements whose stress fades
  std::size_t n_free = 0;              ///< nodes in contact whose elements are all dead
  std::vector<SurfaceChange> changes;  ///< [n_surfaces], summed; empty without contact
};

/// One report of deaths: how many; of `some` and `full` a row of every surface that has changed, faces gained
/// and lost and now owned; of `full` the ownership table of now.
///   contact  null without contact
std::string format_deaths(const DeathTally& tally, const State& state, DeathLog detail,
                          const ContactModel* contact, const Mesh& mesh);

/// How many died in the run, for its end.
std::string format_death_total(const DeathTally& tally, std::size_t n_may_die);

}  // namespace contactsim
