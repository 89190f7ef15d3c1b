// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace contactsim::test {

/// A deck by its lines.
struct SeedDeck {
  std::vector<std::string> lines;
  std::vector<std::vector<std::size_t>> around;  ///< of each line: the BEGIN lines of the blocks around it
};

/// What mutated decks are made of.
struct DeckSeeds {
  std::vector<SeedDeck> decks;     ///< the corpus, then all decks of the repository
  std::vector<std::string> words;  ///< of the command tables and the seed decks, each once, sorted
};

std::vector<std::string> split_lines(std::string_view text);

/// The corpus of the fuzzer and all decks of a repository, in the order of their paths.
DeckSeeds read_deck_seeds(const std::filesystem::path& repository);

}  // namespace contactsim::test
