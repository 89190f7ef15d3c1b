// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "parser/binding/given_rows.hpp"
#include "parser/binding/meant_words.hpp"
#include "parser/text/syntax.hpp"
#include "parser/text/word_grammar.hpp"

namespace contactsim {

namespace {

/// The words of an item by which it is known: of a command all, of a block its title.
const std::vector<Word>& words_of(const Item& item) {
  const Block* block = std::get_if<Block>(&item.value);
  return block ? block->title : std::get<Command>(item.value).words;
}

std::optional<MatchedItem> find_row(const Item& item, const TableText& table) {
  const bool is_block = std::holds_alternative<Block>(item.value);
  const auto& words = words_of(item);
  if (const auto match = (is_block ? table.blocks : table.commands).find(words)) return match;
  if (is_block || words.empty()) return std::nullopt;
  const bool is_table_line = is_number(words.front().text) && table.numbers_row < table.rows.size();
  if (is_table_line) return MatchedItem{table.numbers_row, 0};
  if (table.anything_row < table.rows.size()) return MatchedItem{table.anything_row, 0};
  return std::nullopt;
}

int underline(const std::vector<Word>& words, std::size_t n) {
  return static_cast<int>(joined_words(words, n).size());
}

std::string block_title(const Block& block) {
  return block.title.empty() ? "the deck's top level"
                             : fmt::format("'{}'", joined_words(block.title, block.title.size()));
}

/// What may have been meant, the surest guess first.
std::string hint_for_unknown(const std::vector<Word>& words, bool is_block, const Block& block,
                             const TableText& table) {
  if (std::string inside = find_inner_place(words, is_block, table); !inside.empty()) return inside;
  const std::string nearest = (is_block ? table.blocks : table.commands).nearest(words);
  if (!nearest.empty()) return fmt::format("did you mean '{}{}'?", is_block ? "begin " : "", nearest);
  const std::string other = (is_block ? table.commands : table.blocks).nearest(words);
  if (!other.empty() && is_block) return fmt::format("'{}' is a command line here, not a block", other);
  if (!other.empty()) return fmt::format("'{0}' is a block here: begin {0}", other);
  return find_meaning(words, is_block, block.title, table);
}

void report_unknown(const Item& item, const Block& block, const TableText& table, Binding& binding) {
  const auto& words = words_of(item);
  if (words.empty()) return;  // a BEGIN without a type, which is told of where lines are put into blocks
  const bool is_block = std::holds_alternative<Block>(item.value);
  const std::string hint = hint_for_unknown(words, is_block, block, table);
  const std::size_t n_shown = 4;
  std::string text =
      fmt::format("unknown {} '{}{}' in {}", is_block ? "block" : "command", joined_words(words, n_shown),
                  words.size() > n_shown ? " ..." : "", block_title(block));
  const DeckLocation& place = words.front().location;
  if (binding.is_lenient) {
    binding.diagnostics.add_warning("deck-unknown", place, text + ", passed over", hint,
                                    underline(words, n_shown));
  } else {
    binding.diagnostics.add_error(place, text, hint, underline(words, n_shown));
  }
}

/// A row's help as the second part of a message: in lower case, unless it begins with a keyword.
std::string as_hint(std::string help) {
  const auto is_capital = [&](std::size_t i) { return i < help.size() && help[i] >= 'A' && help[i] <= 'Z'; };
  if (is_capital(0) && !is_capital(1)) help[0] = static_cast<char>(help[0] - 'A' + 'a');
  return help;
}

/// Reports a row that is not supported; returns whether the item may be bound.
bool check_support(const Item& item, const MatchedItem& matched, const RowText& row, Binding& binding) {
  if (row.support == Support::supported) return true;
  const auto& words = words_of(item);
  const DeckLocation& place = words.front().location;
  const int length = underline(words, matched.n_words);
  const std::string hint = as_hint(row.help);
  const std::string what = fmt::format("{}'{}'", row.is_block ? "block " : "", row.phrase);
  if (row.support == Support::ignored) {
    binding.diagnostics.add_warning("deck-ignored", place, what + " has no effect here", hint, length);
  } else if (binding.is_lenient) {
    binding.diagnostics.add_warning("deck-refused", place, what + " is not supported, passed over", hint,
                                    length);
  } else {
    binding.diagnostics.add_error(place, what + " is not supported and would change the answer", hint,
                                  length);
  }
  return false;
}

void report(const ArgumentError& error, Binding& binding) {
  Diagnostic diagnostic = error.diagnostic;
  if (error.is_refusal && binding.is_lenient) {
    diagnostic.severity = Severity::warning;
    diagnostic.id = "deck-refused";
    diagnostic.text += ", passed over";
  }
  binding.diagnostics.add(std::move(diagnostic));
}

/// Whether the END of a block calls its type by another spelling than its BEGIN does: BEGIN HEARTBEAT OUPUT,
/// END HEARTBEAT OUTPUT.
bool ends_in_other_spelling(const Block& block, const MatchedItem& matched, const TableText& table) {
  const auto ended = table.blocks.find(block.end);
  if (!ended || ended->row != matched.row) return false;
  return fold(joined_words(block.end, ended->n_words)) != fold(joined_words(block.title, matched.n_words));
}

/// Whether a row says what its reader reads names of.
[[maybe_unused]] bool declares(const RowText& row, const NameNotes& notes) {
  return std::all_of(notes.referred.begin(), notes.referred.end(), [&](const NamedKind& name) {
    return std::find(row.references.begin(), row.references.end(), name.kind) != row.references.end();
  });
}

}  // namespace

void bind_block(Binding& binding, const BlockHead& head, const std::function<void(Binding&)>& bind) {
  if (binding.names == nullptr) return bind(binding);
  DeckNames& names = *binding.names;
  names.begin_block(head.phrase, head.kind, head.name);
  for (const NameKind kind : head.references) names.refer(kind, head.name);
  Binding inner{names.problems_of_lines(binding.diagnostics), binding.is_lenient, &names};
  const std::size_t n_before = inner.diagnostics.error_count();
  try {
    bind(inner);
    if (inner.diagnostics.error_count() > n_before) names.note_wrong_lines();
  } catch (const ArgumentError& error) {
    names.drop_block();
    report(error, inner);
  }
  names.end_block();
}

void bind_items(const Block& block, const TableText& table, Binding& binding,
                const std::function<void(const Item&, const MatchedItem&)>& bind) {
  GivenRows given(table);
  for (const Item& item : block.items) {
    const auto matched = find_row(item, table);
    if (!matched) {
      // Behind a missing END stands what belongs to the block around.
      if (block.is_closed) report_unknown(item, block, table, binding);
      continue;
    }
    const Block* inner = std::get_if<Block>(&item.value);
    if (inner != nullptr && !ends_in_other_spelling(*inner, *matched, table)) {
      check_end(*inner, matched->n_words, binding.diagnostics);
    }
    if (!check_support(item, *matched, table.rows[matched->row], binding)) continue;
    given.add(words_of(item), *matched, binding.diagnostics);
    try {
      bind(item, *matched);
    } catch (const ArgumentError& error) {
      report(error, binding);
    }
  }
  if (binding.names != nullptr) given.check(*binding.names);
}

void note_findings(const Arguments& arguments, const RowText& row, Binding& binding) {
  for (const Diagnostic& warning : arguments.warnings()) binding.diagnostics.add(warning);
  assert(declares(row, arguments.notes()));
  if (binding.names != nullptr) binding.names->note(row.phrase, arguments.notes());
}

void note_open_names(const Arguments& arguments, const RowText& row, Binding& binding) {
  if (binding.names == nullptr) return;
  NameNotes notes;
  notes.left_open = arguments.notes().left_open;
  binding.names->note(row.phrase, notes);
}

BlockHead head_of(const Block& block, const RowText& row, const MatchedItem& matched) {
  return {row.phrase, row.defines, block_name(block, matched.n_words), row.references};
}

DeckName block_name(const Block& block, std::size_t n_type_words) {
  if (block.title.size() <= n_type_words) return {"", block.location};
  DeckName name{block.title[n_type_words].text, block.title[n_type_words].location};
  for (std::size_t i = n_type_words + 1; i < block.title.size(); ++i) name.text += " " + block.title[i].text;
  return name;
}

std::vector<DeckName> block_names(const Block& block, std::string_view phrase) {
  std::vector<DeckName> names;
  const std::size_t n_type_words = match_phrase(split_phrase(phrase), block.title);
  for (std::size_t i = n_type_words; i < block.title.size(); ++i) {
    names.push_back({block.title[i].text, block.title[i].location});
  }
  return names;
}

Arguments make_arguments(const Command& command, const MatchedItem& matched) {
  const std::size_t n_named = std::max<std::size_t>(matched.n_words, 1);
  return Arguments(joined_words(command.words, n_named), std::span(command.words).subspan(matched.n_words),
                   command, command.words.front().location);
}

}  // namespace contactsim
