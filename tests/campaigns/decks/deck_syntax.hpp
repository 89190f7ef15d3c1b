// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "campaigns/decks/deck_seeds.hpp"
#include "campaigns/support/case_random.hpp"

namespace contactsim::test {

/// A number of the kind that breaks programs, or a plain one.
std::string draw_number(CaseRandom& random);

/// What stands for a syntax of the command tables, "{ON|OFF} [<real> ...]": braces choose, brackets may be
/// left out, names in angles become numbers or names, dots repeat.
std::string draw_arguments(std::string_view syntax, const DeckSeeds& seeds, CaseRandom& random);

}  // namespace contactsim::test
