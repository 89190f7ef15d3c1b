// SPDX-License-Identifier: BSD-3-Clause
#include "parser/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "core/base/names.hpp"
#include "core/base/wrap_text.hpp"
#include "parser/command_tree.hpp"
#include "parser/row_reference.hpp"

namespace contactsim {

namespace {

constexpr std::size_t help_column = 56;
constexpr std::size_t n_nearest = 5;

/// Left column, then help from help_column on, or on the next line when the left column is too long.
///   indent  of both
std::string two_columns(std::size_t indent, const std::string& left, const std::string& help) {
  std::string text = std::string(indent, ' ') + left;
  if (text.size() + 2 > help_column) {
    text = std::string(indent, ' ') + wrap_text(left, indent, indent + 4) + std::string(help_column, ' ');
  } else {
    text += std::string(help_column - text.size(), ' ');
  }
  return text + wrap_text(help, help_column, help_column);
}

std::string support_note(const RowText& row) {
  switch (row.support) {
    case Support::supported:
      return "";
    case Support::ignored:
      return "(ignored) ";
    case Support::refused:
      return "(refused) ";
  }
  return "";
}

std::string block_tree() {
  std::string text =
      "The blocks of a deck. 'contactsim explain WORDS' tells more about a block or command.\n"
      "A deck may also hold the inside of a region or of a contact definition alone.\n\n";
  for (const TreeRow& entry : command_tree()) {
    if (!entry.row->is_block) continue;
    std::string help = support_note(*entry.row) + reference_of(entry).help;
    if (entry.same_as != nullptr) help += fmt::format("; inside as in {}", upper(entry.same_as->phrase));
    text += two_columns(2 * entry.around.size(), deck_form_of(*entry.row), help);
  }
  return text;
}

std::string blanks_for_underscores(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string joined_phrase(std::span<const std::string> words) {
  std::string query;
  for (const std::string& word : words) {
    const std::string folded = fold(word);
    if (query.empty() && (folded == "begin" || folded == "end")) continue;
    query += (query.empty() ? "" : "_") + folded;
  }
  return blanks_for_underscores(query);
}

bool any_phrase(const RowText& row, const std::function<bool(const std::string&)>& fits) {
  const auto& others = row.spellings;
  return fits(blanks_for_underscores(row.phrase)) || std::any_of(others.begin(), others.end(), fits);
}

bool is_phrase(const RowText& row, const std::string& query) {
  return any_phrase(row, [&](const std::string& phrase) { return phrase == query; });
}

bool holds(const RowText& row, const std::string& query) {
  return any_phrase(row, [&](const std::string& phrase) { return phrase.find(query) != std::string::npos; });
}

/// What a matching row says; `places` are the blocks in which it stands.
std::string row_entry(const TreeRow& entry, const std::vector<std::string>& places) {
  const RowReference row = reference_of(entry);
  std::string text = wrap_text(row.form, 0, 6);
  const auto add = [&](const std::string& label, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {:<11}{}", label, wrap_text(value, 13, 13));
  };
  text += "  " + wrap_text(row.help, 2, 2);
  for (const std::string& spelling : row.spellings) add("also", spelling);
  for (const std::string& name : row.names) add("names", name);
  add("dimension", row.dimension);
  add("default", row.default_text);
  add("choice", row.choice);
  add("support", row.support);
  for (const std::string& place : places) add("in", place);
  return text;
}

/// The lines that may stand in a block, for a block that is asked for by its whole name.
std::string contents_of(const RowText& row) {
  std::string text = "  holds\n";
  for (const RowText& line : row.contents().rows) {
    text += two_columns(4, deck_form_of(line), support_note(line) + help_of(line));
  }
  return text;
}

/// Rows of several blocks that say the same are one entry.
struct Match {
  const TreeRow* entry;
  std::vector<std::string> places;
};

bool says_the_same(const RowText& a, const RowText& b) {
  return a.phrase == b.phrase && a.is_block == b.is_block && a.syntax == b.syntax && a.help == b.help &&
         a.default_text == b.default_text && a.support == b.support && a.is_required == b.is_required &&
         a.choice == b.choice && a.references == b.references;
}

std::vector<Match> find_matches(const std::string& query) {
  std::vector<Match> matches;
  for (const TreeRow& entry : command_tree()) {
    if (entry.row->phrase.empty() || !holds(*entry.row, query)) continue;
    const auto same = std::find_if(matches.begin(), matches.end(),
                                   [&](const Match& m) { return says_the_same(*m.entry->row, *entry.row); });
    if (same == matches.end()) {
      matches.push_back({&entry, {place_of(entry)}});
    } else {
      same->places.push_back(place_of(entry));
    }
  }
  std::stable_partition(matches.begin(), matches.end(),
                        [&](const Match& m) { return is_phrase(*m.entry->row, query); });
  return matches;
}

/// The smallest edit distance of the query to as many neighbouring words of the phrase.
int distance_to(const std::string& query, const std::string& phrase) {
  const auto n_words = std::count(query.begin(), query.end(), ' ') + 1;
  const std::vector<std::string> words = split_phrase(phrase);
  int smallest = edit_distance(query, phrase);
  for (auto first = words.begin(); words.end() - first >= n_words; ++first) {
    const std::string part = fmt::format("{}", fmt::join(first, first + n_words, " "));
    smallest = std::min(smallest, edit_distance(query, part));
  }
  return smallest;
}

std::string nearest_phrases(const std::string& query) {
  std::set<std::pair<int, std::string>> by_distance;
  for (const TreeRow& entry : command_tree()) {
    const std::string& phrase = entry.row->phrase;
    if (!phrase.empty()) by_distance.emplace(distance_to(query, phrase), phrase);
  }
  std::string text = fmt::format("No block or command is called '{}'. The nearest are\n", query);
  std::size_t n_shown = 0;
  for (const auto& [distance, phrase] : by_distance) {
    if (++n_shown > n_nearest) break;
    text += "  " + phrase + '\n';
  }
  return text;
}

}  // namespace

Explanation explain(std::span<const std::string> words) {
  const std::string query = joined_phrase(words);
  if (query.empty()) return {block_tree()};
  const std::vector<Match> matches = find_matches(query);
  if (matches.empty()) return {nearest_phrases(query), false};
  std::string text;
  for (const Match& match : matches) {
    if (!text.empty()) text += '\n';
    const RowText& row = *match.entry->row;
    text += row_entry(*match.entry, match.places);
    if (row.contents && is_phrase(row, query)) text += contents_of(row);
  }
  return {text};
}

}  // namespace contactsim
