// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "campaigns/decks/deck_seeds.hpp"
#include "campaigns/support/case_random.hpp"

namespace contactsim::test {

/// The lines that a case begins with, before they are mutated: a seed deck, a part of one with the blocks
/// around it, lines of several, or lines of the command tables within their blocks.
std::vector<std::string> draw_lines(const DeckSeeds& seeds, CaseRandom& random);

}  // namespace contactsim::test
