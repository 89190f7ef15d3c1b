// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parser/text/syntax.hpp"

namespace contactsim {

namespace {

std::size_t find_row(const std::vector<RowText>& rows, RowText::Matches matches) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const RowText& r) { return r.matches == matches; });
  return static_cast<std::size_t>(row - rows.begin());
}

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

std::string shown(const std::vector<Word>& words, std::size_t n) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(n, words.size()); ++i) texts.push_back(words[i].text);
  return fmt::format("{}", fmt::join(texts, " "));
}

int underline(const std::vector<Word>& words, std::size_t n) {
  return static_cast<int>(shown(words, n).size());
}

std::string block_title(const Block& block) {
  return block.title.empty() ? "the deck's top level"
                             : fmt::format("'{}'", shown(block.title, block.title.size()));
}

void report_unknown(const Item& item, const Block& block, const TableText& table, Binding& binding) {
  const auto& words = words_of(item);
  const bool is_block = std::holds_alternative<Block>(item.value);
  const std::string nearest = (is_block ? table.blocks : table.commands).nearest(words);
  const std::string other = (is_block ? table.commands : table.blocks).nearest(words);
  std::string hint;
  if (!nearest.empty()) {
    hint = fmt::format("did you mean '{}{}'?", is_block ? "begin " : "", nearest);
  } else if (!other.empty()) {
    hint = is_block ? fmt::format("'{}' is a command line here, not a block", other)
                    : fmt::format("'{0}' is a block here: begin {0}", other);
  }
  const std::size_t n_shown = 4;
  std::string text =
      fmt::format("unknown {} '{}{}' in {}", is_block ? "block" : "command", shown(words, n_shown),
                  words.size() > n_shown ? " ..." : "", block_title(block));
  const DeckLocation& place = words.empty() ? block.location : words.front().location;
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
  return fold(shown(block.end, ended->n_words)) != fold(shown(block.title, matched.n_words));
}

/// Notices lines that replace an earlier line of the same block.
class RepeatedLines {
 public:
  explicit RepeatedLines(const TableText& table) : table_(&table), latest_(table.rows.size(), nullptr) {}

  void check(const Item& item, const MatchedItem& matched, Diagnostics& diagnostics) {
    const RowText& row = table_->rows[matched.row];
    if (!row.is_single) return;
    const auto& words = words_of(item);
    const Word*& latest = latest_[matched.row];
    if (latest != nullptr) {
      diagnostics.add_warning("deck-repeated", words.front().location,
                              fmt::format("'{}' is given twice in one block, this one counts", row.phrase),
                              "the other stands at " + to_string(latest->location),
                              underline(words, matched.n_words));
    }
    latest = &words.front();
  }

 private:
  const TableText* table_;
  std::vector<const Word*> latest_;  ///< of each row: the latest line of it
};

}  // namespace

RowPhrases::RowPhrases(const std::vector<RowText>& rows, bool is_for_blocks) {
  std::vector<std::string> phrases;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].is_block != is_for_blocks || rows[i].matches != RowText::Matches::phrase) continue;
    phrases.push_back(rows[i].phrase);
    phrases.insert(phrases.end(), rows[i].spellings.begin(), rows[i].spellings.end());
    rows_.resize(phrases.size(), i);
  }
  index_ = PhraseIndex(phrases);
}

std::optional<MatchedItem> RowPhrases::find(std::span<const Word> words) const {
  const auto match = index_.find(words);
  if (!match) return std::nullopt;
  return MatchedItem{rows_[match->phrase], match->n_words};
}

std::string use_key(std::string_view kind, std::string_view name) {
  return fmt::format("{}/{}", kind, fold(name));
}

TableText::TableText(std::vector<RowText> row_texts)
    : rows(std::move(row_texts)),
      commands(rows, false),
      blocks(rows, true),
      numbers_row(find_row(rows, RowText::Matches::numbers)),
      anything_row(find_row(rows, RowText::Matches::anything)) {}

void bind_held(Binding& binding, const std::string& key, const std::function<void(Binding&)>& bind) {
  Diagnostics problems;
  Binding inner{problems, binding.is_lenient, binding.held};
  try {
    bind(inner);
  } catch (const ArgumentError& error) {
    problems.add(error.diagnostic);
  }
  if (binding.held == nullptr) {
    binding.diagnostics.append(problems);
  } else if (!problems.empty()) {
    binding.held->push_back({key, std::move(problems)});
  }
}

void bind_items(const Block& block, const TableText& table, Binding& binding,
                const std::function<void(const Item&, const MatchedItem&)>& bind) {
  RepeatedLines repeated(table);
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
    repeated.check(item, *matched, binding.diagnostics);
    try {
      bind(item, *matched);
    } catch (const ArgumentError& error) {
      report(error, binding);
    }
  }
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
  return Arguments(shown(command.words, n_named), std::span(command.words).subspan(matched.n_words), command,
                   command.words.front().location);
}

}  // namespace contactsim
