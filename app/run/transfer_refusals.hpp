// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/run/run_input.hpp"
#include "contact/surfaces/surface_pairs.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// Adds an error for everything that is not supported where a procedure takes over the state of the one
/// before, as far as the deck and the contact surfaces show it; find_state_transfer() says what the models
/// show. Precondition: there is a procedure before, and a transfer.
void refuse_in_transfer(const RunInput& input, Diagnostics& diagnostics);

/// Adds an error where contact that is not taken over would hold what is near at the start: what held it so
/// far would be lost.
void refuse_held_without_transfer(const SurfacePairs& pairs, Diagnostics& diagnostics);

}  // namespace contactsim
