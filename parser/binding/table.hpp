// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/binding/arguments.hpp"
#include "parser/binding/table_text.hpp"
#include "parser/text/ast.hpp"

namespace contactsim {

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
    texts.reserve(rows.size());
    for (const Row<T>& row : rows) texts.push_back(row.text);
    return TableText(std::move(texts));
  }

  TableText text_;
  std::vector<Row<T>> rows_;
};

}  // namespace contactsim
