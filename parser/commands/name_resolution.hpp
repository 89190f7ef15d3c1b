// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/definition/simulation.hpp"
#include "parser/binding/deck_names.hpp"

namespace contactsim {

/// Looks up every name that the deck uses, after all of it is bound, and checks the definitions that are
/// used, directly or through other definitions, by a region or a time control. In a deck of contact alone a
/// name may be defined elsewhere, and every finite element model is used.
///   names  what binding the deck noted
void resolve_names(const SimulationDefinition& simulation, DeckNames& names, Diagnostics& diagnostics);

}  // namespace contactsim
