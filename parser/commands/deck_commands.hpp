// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/simulation.hpp"
#include "parser/commands/rows.hpp"
#include "parser/text/ast.hpp"

namespace contactsim {

/// What a deck holds, by its outermost items: BEGIN SIERRA makes it a full deck, else BEGIN CONTACT
/// DEFINITION tells a definition from the commands of one.
DeckForm find_deck_form(const Block& deck);

/// The outermost level of a deck of the form. Tables of contact alone bind into the first region of the first
/// procedure, which must be there.
const Table<SimulationDefinition>& deck_table(DeckForm form);

}  // namespace contactsim
