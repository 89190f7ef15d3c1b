// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/binding/name_kinds.hpp"
#include "parser/text/ast.hpp"
#include "parser/text/phrases.hpp"

/// What the rows of a table say about their commands, apart from how they bind.
namespace contactsim {

/// What contactsim does with a command that it knows.
enum class Support {
  supported,  ///< bound into the definition tree
  ignored,    ///< cannot change the answer: read, warned about once per command
  refused     ///< would change the answer: an error, or with --lenient a warning
};

/// One item of a block together with the row that knows it.
struct MatchedItem {
  std::size_t row = 0;
  std::size_t n_words = 0;  ///< words of the line, or of the block's title, that the row's phrase takes
};

struct TableText;

/// Rows of a block that stand for one another: those with equal texts are one choice.
struct Choice {
  std::string lack;    ///< what is said when none is given, "has no direction"; "": none need be
  std::string excess;  ///< what is said when several are given, "has two values"; "": all may be
  bool operator==(const Choice&) const = default;
};

/// What a row says about its command. The parser, the suggestions, `contactsim explain` and the coverage
/// tests all read this.
struct RowText {
  enum class Matches {
    phrase,
    numbers,
    anything
  };  ///< the last two: lines of a table, lines of an opaque block

  std::string phrase;  ///< keyword words in lower case, "friction coefficient"; also of blocks, without BEGIN
  std::string syntax;  ///< what follows the phrase, "= <real >= 0>"; for a block the form of its name
  std::string help;    ///< one line; dimensions in brackets, "Coulomb coefficient [1]"
  std::string default_text;  ///< "0", "none", "required", "OFF"
  Support support = Support::supported;
  Matches matches = Matches::phrase;
  bool is_block = false;
  std::function<const TableText&()> contents = nullptr;  ///< of a block whose commands are known
  bool is_single = false;  ///< a second such line in a block replaces the first, which is worth a warning
  std::vector<std::string> spellings = {};  ///< further phrases by which the deck may call it
  bool is_required = false;                 ///< a block without such a line lacks it
  Choice choice = {};                       ///< both texts "": no choice
  std::vector<NameKind> references = {};    ///< what names in the line, or after BEGIN, stand for
  std::optional<NameKind> defines = {};     ///< what the name of the line or block is defined to be

  bool is_choice() const { return choice != Choice{}; }
};

/// A row as a deck would have it, keywords in capitals: "BEGIN FUNCTION <name>", "THICKNESS = <real > 0>".
std::string deck_form_of(const RowText& row);

/// The dimensions in brackets of a row's help: "length/time", of several "length, force", "" of none.
std::string dimension_of(const RowText& row);

/// The rows of one choice of a table as their phrases, "COMPONENT, DIRECTION and CYLINDRICAL AXIS".
///   conjunction  "and" or "or"
std::string phrases_of_choice(const TableText& table, const Choice& choice, std::string_view conjunction);

/// The phrases of the commands of a block, or of its inner blocks, and the rows that they belong to.
class RowPhrases {
 public:
  RowPhrases(const std::vector<RowText>& rows, bool is_for_blocks);
  /// The row with the longest phrase that the words begin with.
  std::optional<MatchedItem> find(std::span<const Word> words) const;
  /// The known phrase nearest to the beginning of the words; "" when none is near.
  std::string nearest(std::span<const Word> words) const { return index_.nearest(words); }

 private:
  std::vector<std::size_t> rows_;  ///< of each phrase of index_
  PhraseIndex index_;
};

/// The rows of one block type.
struct TableText {
  explicit TableText(std::vector<RowText> row_texts);
  std::vector<RowText> rows;
  RowPhrases commands;
  RowPhrases blocks;
  std::vector<std::size_t> needed;  ///< positions of the rows that are required or part of a choice
  std::size_t numbers_row;          ///< position of the row of Matches::numbers, rows.size() if none
  std::size_t anything_row;         ///< position of the row of Matches::anything, rows.size() if none
};

}  // namespace contactsim
