// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace contactsim::test {

/// How much of what a deck must hold is looked at.
enum class DeckLook { all, some };

/// Runs a text as a deck and says which of these does not hold, "" when all do:
/// every problem has a text of one line, and a place within the text that it is in; the text for a terminal
/// is not longer than so many times the deck; without errors, the numbers of the definition are finite, and
/// its functions can be made or are reported. `all`: a second run says the same; a lenient run finds no more
/// errors.
std::string find_deck_harm(std::string_view text, DeckLook look);

}  // namespace contactsim::test
