// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "parser/arguments.hpp"
#include "parser/ast.hpp"
#include "parser/phrases.hpp"

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
};

/// The phrases of the commands of a block, or of its inner blocks, and the rows that they belong to.
class RowPhrases {
 public:
  RowPhrases(const std::vector<RowText>& rows, bool of_blocks);
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
  std::size_t numbers_row;   ///< position of the row of Matches::numbers, rows.size() if none
  std::size_t anything_row;  ///< position of the row of Matches::anything, rows.size() if none
};

/// The problems of a definition that matter only if something uses it.
struct HeldDiagnostics {
  std::string key;  ///< says which definition: see use_key
  Diagnostics found;
};

/// What binding a deck needs besides the blocks: where problems go, and how strict to be.
struct Binding {
  Diagnostics& diagnostics;
  bool is_lenient = false;
  std::vector<HeldDiagnostics>* held = nullptr;  ///< null: definitions count as used
};

/// The key under which the problems of a definition are held: "material/steel", names case-blind.
std::string use_key(std::string_view kind, std::string_view name);

/// Binds with the problems held back under a key when the binding can hold them, else reports them at once.
/// ArgumentErrors that `bind` throws are collected.
void bind_held(Binding& binding, const std::string& key, const std::function<void(Binding&)>& bind);

/// Goes through the items of a block in deck order, calls `bind` for every item that has a supported row, and
/// reports the rest: unknown words with the nearest known ones, ignored and refused commands, and a command
/// that replaces an earlier one. ArgumentErrors that `bind` throws are collected.
void bind_items(const Block& block, const TableText& table, Binding& binding,
                const std::function<void(const Item&, const MatchedItem&)>& bind);

/// The name in a block's title after its type; the words are joined by blanks. Its text is "" when there is
/// none.
DeckName block_name(const Block& block, std::size_t n_type_words);

/// The words of a block's title after its type, one name each.
std::vector<DeckName> block_names(const Block& block, std::string_view phrase);

/// Makes the arguments of a matched command.
Arguments make_arguments(const Command& command, const MatchedItem& matched);

/// One row of a table: a command (or block) and how it is bound into a T.
template <class T>
struct Row {
  RowText text;
  std::function<void(Arguments&, T&)> read_command = nullptr;                             ///< of a command
  std::function<void(const Block&, const DeckName&, T&, Binding&)> read_block = nullptr;  ///< of a block

  /// The same row with one more phrase by which the deck may call it.
  Row or_spelled(std::string phrase) && {
    text.spellings.push_back(std::move(phrase));
    return std::move(*this);
  }
  /// The same row, of which a block should hold one line at most.
  Row once() && {
    text.is_single = true;
    return std::move(*this);
  }
};

/// The commands and blocks that may stand in one block type, bound into a T.
template <class T>
class Table {
 public:
  Table(std::vector<Row<T>> rows) : text_(texts_of(rows)), rows_(std::move(rows)) {}

  const TableText& text() const { return text_; }
  const std::vector<Row<T>>& rows() const { return rows_; }

  void bind(const Block& block, T& target, Binding& binding) const {
    bind_items(block, text_, binding, [&](const Item& item, const MatchedItem& matched) {
      const Row<T>& row = rows_[matched.row];
      if (const Block* inner = std::get_if<Block>(&item.value)) {
        row.read_block(*inner, block_name(*inner, matched.n_words), target, binding);
      } else {
        Arguments arguments = make_arguments(std::get<Command>(item.value), matched);
        row.read_command(arguments, target);
        arguments.expect_end();
        for (const Diagnostic& warning : arguments.warnings()) binding.diagnostics.add(warning);
      }
    });
  }

 private:
  static TableText texts_of(const std::vector<Row<T>>& rows) {
    std::vector<RowText> texts;
    for (const Row<T>& row : rows) texts.push_back(row.text);
    return TableText(std::move(texts));
  }

  TableText text_;
  std::vector<Row<T>> rows_;
};

}  // namespace contactsim
