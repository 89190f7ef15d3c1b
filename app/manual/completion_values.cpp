// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/completion_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "parser/command_tree.hpp"
#include "parser/text/phrases.hpp"

namespace contactsim {

Completes completion_of(const OptionText& option) {
  const std::string& value = option.value;
  if (!option.choices.empty()) return Completes::words;
  if (value == "DECK") return Completes::deck;
  if (value == "MESH") return Completes::mesh;
  if (value == "FILE" || value == "A" || value == "B") return Completes::file;
  if (value == "FOLDER") return Completes::folder;
  return value == "WORDS" ? Completes::phrases : Completes::nothing;
}

std::string phrase_words() {
  std::set<std::string> words;
  for (const TreeRow& entry : command_tree()) {
    for (const std::string& word : split_phrase(entry.row->phrase)) words.insert(word);
  }
  return fmt::format("{}", fmt::join(words, " "));
}

std::string names_of(const std::vector<OptionText>& options) {
  std::string names;
  for (const OptionText& option : options)
    names += fmt::format("{}{}", names.empty() ? "" : " ", fmt::join(option.names, " "));
  return names;
}

std::string subcommands_of(const CommandLineText& commands) {
  std::string names;
  for (const CommandText& command : commands) names += (names.empty() ? "" : " ") + command.name;
  return names;
}

}  // namespace contactsim
