// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/phrase_pattern.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "parser/command_tree.hpp"
#include "parser/text/phrases.hpp"

namespace contactsim {

namespace {

/// What a phrase is coloured as: the first of these that a row says.
enum class Colour { block, command, ignored, refused };

Colour colour_of(const RowText& row) {
  if (row.support == Support::refused) return Colour::refused;
  if (row.support == Support::ignored) return Colour::ignored;
  return row.is_block ? Colour::block : Colour::command;
}

/// Blocks stand behind BEGIN, so that the same words may be a command too.
std::string key_of(const RowText& row, const std::string& phrase) {
  return (row.is_block ? "begin " : "") + fmt::format("{}", fmt::join(split_phrase(phrase), " "));
}

}  // namespace

PhraseSets phrase_sets() {
  std::map<std::string, Colour> colours;
  const auto add = [&](const RowText& row, const std::string& phrase) {
    const Colour colour = colour_of(row);
    const auto [known, is_new] = colours.try_emplace(key_of(row, phrase), colour);
    if (!is_new) known->second = std::min(known->second, colour);
  };
  for (const TreeRow& entry : command_tree()) {
    if (entry.row->phrase.empty()) continue;
    add(*entry.row, entry.row->phrase);
    for (const std::string& spelling : entry.row->spellings) add(*entry.row, spelling);
  }
  PhraseSets sets;
  for (const auto& [phrase, colour] : colours) {
    auto& set = colour == Colour::block     ? sets.blocks
                : colour == Colour::command ? sets.commands
                : colour == Colour::ignored ? sets.ignored
                                            : sets.refused;
    set.push_back(phrase);
  }
  for (auto* set : {&sets.blocks, &sets.commands, &sets.ignored, &sets.refused}) {
    std::stable_sort(set->begin(), set->end(),
                     [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  }
  return sets;
}

std::string phrase_pattern(const std::vector<std::string>& phrases, const std::string& blank,
                           const std::string& bar) {
  std::string pattern;
  for (const std::string& phrase : phrases)
    pattern += (pattern.empty() ? "" : bar) + fmt::format("{}", fmt::join(split_phrase(phrase), blank));
  return pattern;
}

}  // namespace contactsim
