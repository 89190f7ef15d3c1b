// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/table_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace contactsim {

namespace {

std::size_t find_row(const std::vector<RowText>& rows, RowText::Matches matches) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const RowText& r) { return r.matches == matches; });
  return static_cast<std::size_t>(row - rows.begin());
}

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

TableText::TableText(std::vector<RowText> row_texts)
    : rows(std::move(row_texts)),
      commands(rows, false),
      blocks(rows, true),
      numbers_row(find_row(rows, RowText::Matches::numbers)),
      anything_row(find_row(rows, RowText::Matches::anything)) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].is_required || rows[i].is_choice()) needed.push_back(i);
  }
}

std::string deck_form_of(const RowText& row) {
  const std::string text = (row.is_block ? "BEGIN " : "") + upper(row.phrase);
  const bool is_glued = text.empty() || row.syntax.empty() || row.syntax.front() == ':';
  return text + (is_glued ? "" : " ") + row.syntax;
}

std::string dimension_of(const RowText& row) {
  std::string dimensions;
  for (std::size_t open = row.help.find('['); open != std::string::npos;
       open = row.help.find('[', open + 1)) {
    const std::size_t close = row.help.find(']', open);
    if (!dimensions.empty()) dimensions += ", ";
    dimensions += row.help.substr(open + 1, close - open - 1);
  }
  return dimensions;
}

std::string phrases_of_choice(const TableText& table, const Choice& choice, std::string_view conjunction) {
  std::vector<std::string> phrases;
  for (const std::size_t i : table.needed) {
    if (table.rows[i].choice == choice) phrases.push_back(upper(table.rows[i].phrase));
  }
  if (phrases.empty()) return "";
  const std::string last = std::move(phrases.back());
  phrases.pop_back();
  if (phrases.empty()) return last;
  return fmt::format("{} {} {}", fmt::join(phrases, ", "), conjunction, last);
}

}  // namespace contactsim
