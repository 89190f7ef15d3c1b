// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "campaigns/decks/deck_seeds.hpp"
#include "campaigns/support/case_random.hpp"

namespace contactsim::test {

/// The deck of a case: lines by draw_lines, then changed some times, by lines, words and bytes.
std::string draw_deck(const DeckSeeds& seeds, CaseRandom& random);

}  // namespace contactsim::test
