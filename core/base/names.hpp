// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/deck_location.hpp"

namespace contactsim {

/// A name that the deck uses, in the deck's spelling, and where it stands.
struct DeckName {
  std::string text;
  DeckLocation location;
};

/// Whether two names are the same to the deck, by fold(); where they stand does not matter.
bool operator==(const DeckName& a, const DeckName& b);

/// The spelling by which user names are compared: lower case, blanks as underscores.
/// Source: Sierra/SM decks ignore case; IOSS replaces blanks in mesh names by underscores.
std::string fold(std::string_view name);

/// Number of single-character insertions, deletions, replacements and swaps of neighbours that turn a into b.
/// Source: Damerau, CACM 7 (1964) 171-176 (restricted form, no substring edited twice).
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to the word, when it is near enough to be what was meant (a third of its length);
/// none for words of more than 256 characters.
/// The first listed wins a tie. Comparison is case-blind.
std::optional<std::string> find_nearest(std::string_view word, std::span<const std::string> candidates);

/// "did you mean 'steel'?", or "" when nothing is near.
std::string suggest(std::string_view word, std::span<const std::string> candidates);

}  // namespace contactsim
