// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/names.hpp"
#include "parser/text/ast.hpp"

/// The values of commands, as rules over words; word_grammar.hpp says what may stand in one word.
///   real      = a bare or quoted word that is a real number; integer alike
///   name      = any bare or quoted word
///   vector    = real real real
///   reals     = real { real }          integers and names alike; all words that remain
///   separator = "=" | IS | ARE
namespace contactsim {

/// The words of a line that are still to be read.
using Words = std::span<const Word>;

/// Thrown where words do not fit a rule.
struct ValueError {
  std::string expected;  ///< "a number"
};

/// Each takes what its rule matches from the front of `words`. Where the words do not fit, it throws
/// ValueError, and `words` begins with the one that does not fit or is empty.
double take_real(Words& words);
std::int64_t take_integer(Words& words);
DeckName take_name(Words& words);
Eigen::Vector3d take_vector(Words& words);
std::vector<double> take_reals(Words& words);
std::vector<std::int64_t> take_integers(Words& words);
std::vector<DeckName> take_names(Words& words);

/// Takes a separator if one is next; returns whether it was.
bool take_separator(Words& words);
/// The same for a bare word. Case is ignored; `keyword` is in lower case.
bool take_keyword(Words& words, std::string_view keyword);

struct PhraseTable;

/// Phrases, of which a command takes one.
///   choice = phrase | phrase ...
///   phrase = keyword { keyword }       in bare words of any case, between which '_' may stand for the blank
class Choices {
 public:
  /// Implicit, so that a list of phrases can be given where choices are taken.
  Choices(std::vector<std::string> phrases);
  const std::vector<std::string>& phrases() const { return phrases_; }
  const PhraseTable& table() const { return *table_; }

 private:
  std::vector<std::string> phrases_;
  std::shared_ptr<const PhraseTable> table_;
};

/// Takes the longest phrase that fits; returns its position among the choices, nothing if none fits.
std::optional<std::size_t> take_choice(Words& words, const Choices& choices);

}  // namespace contactsim
