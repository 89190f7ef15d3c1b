// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/text/ast.hpp"

namespace contactsim {

/// The keyword words of a phrase in lower case, cut at blanks and underscores: "node_set" gives {"node",
/// "set"}.
std::vector<std::string> split_phrase(std::string_view phrase);

/// The first n words of a line as one text.
std::string joined_words(const std::vector<Word>& words, std::size_t n);

/// The text in capitals.
std::string upper(std::string_view text);

/// How many words of a line the phrase takes when the line begins with it, 0 when it does not. Case is
/// ignored, and an underscore inside a word counts as a blank, so "node_set" begins with the phrase {"node",
/// "set"}.
std::size_t match_phrase(std::span<const std::string> phrase, std::span<const Word> words);

/// Finds which of a block's keyword phrases a line begins with.
class PhraseIndex {
 public:
  PhraseIndex() = default;
  /// Empty phrases are never found.
  explicit PhraseIndex(std::span<const std::string> phrases);

  struct Match {
    std::size_t phrase = 0;   ///< position in the list given to the constructor
    std::size_t n_words = 0;  ///< words of the line that it takes
  };
  /// The longest phrase that the words begin with.
  std::optional<Match> find(std::span<const Word> words) const;

  /// The known phrase nearest to the beginning of the line, for "did you mean"; "" when none is near.
  std::string nearest(std::span<const Word> words) const;

 private:
  std::vector<std::vector<std::string>> phrases_;
  std::unordered_map<std::string, std::vector<std::size_t>> by_first_word_;  ///< positions in phrases_
};

}  // namespace contactsim
