// SPDX-License-Identifier: BSD-3-Clause
#include "parser/command_tree.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "support/catch.hpp"
#include "support/row_path.hpp"

using namespace contactsim;

namespace {

std::vector<std::string> phrases_of(const RowText& row) {
  std::vector<std::string> phrases = row.spellings;
  if (!row.phrase.empty()) phrases.push_back(row.phrase);
  return phrases;
}

}  // namespace

TEST_CASE("every row has help and a default", "[parser][rows]") {
  for (const TreeRow& entry : command_tree()) {
    INFO(path_of(entry));
    CHECK_FALSE(entry.row->help.empty());
    CHECK_FALSE(entry.row->default_text.empty());
    CHECK(entry.row->help.find('\n') == std::string::npos);
    CHECK(entry.row->help.back() != '.');
  }
}

TEST_CASE("every supported row that takes real numbers tells their dimension", "[parser][rows]") {
  for (const TreeRow& entry : command_tree()) {
    INFO(path_of(entry));
    const std::string& syntax = entry.row->syntax;
    const bool is_real = syntax.find("<real") != std::string::npos || syntax.find("<x>") != std::string::npos;
    if (entry.row->support != Support::supported || !is_real) continue;
    const bool has_dimension = entry.row->help.find('[') != std::string::npos ||
                               entry.row->help.find("dimension") != std::string::npos;
    CHECK(has_dimension);
  }
}

TEST_CASE("every phrase is in lower case and without needless blanks", "[parser][rows]") {
  for (const TreeRow& entry : command_tree()) {
    for (const std::string& phrase : phrases_of(*entry.row)) {
      INFO(path_of(entry));
      for (const char c : phrase) CHECK_FALSE((c >= 'A' && c <= 'Z'));
      CHECK(fmt::format("{}", fmt::join(split_phrase(phrase), " ")).size() == phrase.size());
    }
  }
}

TEST_CASE("no two rows of one block have the same phrase", "[parser][rows]") {
  std::map<std::pair<std::vector<const RowText*>, bool>, std::set<std::string>> seen;
  for (const TreeRow& entry : command_tree()) {
    for (const std::string& phrase : phrases_of(*entry.row)) {
      INFO(path_of(entry));
      const std::string words = fmt::format("{}", fmt::join(split_phrase(phrase), " "));
      CHECK(seen[{entry.around, entry.row->is_block}].insert(words).second);
    }
  }
}

TEST_CASE("a row without a phrase is one of numbers or of any words", "[parser][rows]") {
  for (const TreeRow& entry : command_tree()) {
    INFO(path_of(entry));
    CHECK(entry.row->phrase.empty() == (entry.row->matches != RowText::Matches::phrase));
  }
}

TEST_CASE("a supported block has contents, a refused one has none", "[parser][rows]") {
  for (const TreeRow& entry : command_tree()) {
    INFO(path_of(entry));
    if (!entry.row->is_block) CHECK_FALSE(entry.row->contents);
    if (entry.row->is_block && entry.row->support == Support::supported) CHECK(entry.row->contents);
    if (entry.row->support == Support::refused) CHECK_FALSE(entry.row->contents);
  }
}

TEST_CASE("the contents of a table are listed once", "[parser][rows]") {
  std::set<const TableText*> listed;
  for (const TreeRow& entry : command_tree()) {
    if (!entry.row->contents) continue;
    INFO(path_of(entry));
    CHECK(listed.insert(&entry.row->contents()).second == (entry.same_as == nullptr));
  }
}

TEST_CASE("a row is shown as a deck would have it", "[parser][rows]") {
  CHECK(deck_form_of({"shell section", "<name>", "", "", Support::supported, RowText::Matches::phrase,
                      true}) == "BEGIN SHELL SECTION <name>");
  CHECK(deck_form_of({"thickness", "= <real > 0>", "", ""}) == "THICKNESS = <real > 0>");
  CHECK(deck_form_of({"expression variable", ": <name>", "", ""}) == "EXPRESSION VARIABLE: <name>");
  CHECK(deck_form_of({"include all blocks", "", "", ""}) == "INCLUDE ALL BLOCKS");
}
