// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/binding/arguments.hpp"
#include "parser/binding/deck_names.hpp"
#include "parser/binding/table_text.hpp"
#include "parser/text/ast.hpp"

namespace contactsim {

/// What binding a deck needs besides the blocks: where problems go, and how strict to be.
struct Binding {
  Diagnostics& diagnostics;
  bool is_lenient = false;
  /// Where names and what is missing are noted; null: nowhere, definitions count as used.
  DeckNames* names = nullptr;
};

/// What a block is, for DeckNames.
struct BlockHead {
  std::string_view phrase;       ///< of its row, which must outlive the DeckNames
  std::optional<NameKind> kind;  ///< what its name defines
  DeckName name;
  std::vector<NameKind> references = {};  ///< what its name stands for
};

/// Binds a block, and notes it and what is inside. ArgumentErrors that `bind` throws are collected where
/// names are noted.
void bind_block(Binding& binding, const BlockHead& head, const std::function<void(Binding&)>& bind);

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
/// What the reading of a command's arguments found besides its values: warnings and names.
void note_findings(const Arguments& arguments, const RowText& row, Binding& binding);
/// Of a line that could not be read: that the mesh gives further names, lest what names them be wrong too.
void note_open_names(const Arguments& arguments, const RowText& row, Binding& binding);

BlockHead head_of(const Block& block, const RowText& row, const MatchedItem& matched);

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
  /// The same row, without which a block is not whole.
  Row required() && {
    text.is_required = true;
    text.default_text = "required";
    return std::move(*this);
  }
  /// The same row as part of a choice.
  Row one_of(const Choice& choice) && {
    text.choice = choice;
    return std::move(*this);
  }
  /// The same row, whose names stand for this: what its reader reads by Arguments::reference, or the name of
  /// its block.
  Row references(NameKind kind) && {
    text.references.push_back(kind);
    return std::move(*this);
  }
  /// The same row, whose name is defined here: what its reader reads by Arguments::definition, or the name of
  /// its block.
  Row defines(NameKind kind) && {
    text.defines = kind;
    return std::move(*this);
  }
};

/// The commands and blocks that may stand in one block type, bound into a T.
template <class T>
class Table {
 public:
  /// Adds what is wrong with a T that holds all lines of its block, beyond what the rows say.
  using Check = void (*)(const T&, DeckNames&);

  Table(std::vector<Row<T>> rows, Check check = nullptr)
      : text_(texts_of(rows)), rows_(std::move(rows)), check_(check) {}

  const TableText& text() const { return text_; }
  const std::vector<Row<T>>& rows() const { return rows_; }

  void bind(const Block& block, T& target, Binding& binding) const {
    bind_items(block, text_, binding, [&](const Item& item, const MatchedItem& matched) {
      const Row<T>& row = rows_[matched.row];
      if (const Block* inner = std::get_if<Block>(&item.value)) {
        const BlockHead head = head_of(*inner, row.text, matched);
        bind_block(binding, head,
                   [&](Binding& within) { row.read_block(*inner, head.name, target, within); });
      } else {
        Arguments arguments = make_arguments(std::get<Command>(item.value), matched);
        try {
          row.read_command(arguments, target);
          arguments.expect_end();
        } catch (const ArgumentError&) {
          note_open_names(arguments, row.text, binding);
          throw;
        }
        note_findings(arguments, row.text, binding);
      }
    });
    if (check_ != nullptr && binding.names != nullptr) check_(target, *binding.names);
  }

 private:
  static TableText texts_of(const std::vector<Row<T>>& rows) {
    std::vector<RowText> texts;
    texts.reserve(rows.size());
    for (const Row<T>& row : rows) texts.push_back(row.text);
    return TableText(std::move(texts));
  }

  TableText text_;
  std::vector<Row<T>> rows_;
  Check check_;
};

}  // namespace contactsim
