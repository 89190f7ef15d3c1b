// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "app/run/run_contact.hpp"
#include "app/run/run_input.hpp"
#include "app/run/run_setup.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/statics/shared_elements.hpp"

namespace contactsim {

/// What each rank does of a run; null where nothing is shared. In load steps all ranks get the forces of all
/// nodes, whichever of them they follow. Ranks and the model must outlive it.
///   contact  null without
std::unique_ptr<RankShare> make_share(Ranks& ranks, const RunInput& input, const Setup& setup,
                                      const RunContact* contact);

/// The elements of load steps as ranks share them; null where they do not.
std::unique_ptr<SharedElements> make_shared_elements(const Setup& setup, ForceTerm& internal,
                                                     RankShare* share);

}  // namespace contactsim
