// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>
#include <regex>

#include "app/manual/grammars.hpp"
#include "parser/command_tree.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

std::vector<std::string> phrases_of(const RowText& row) {
  std::vector<std::string> phrases = row.spellings;
  if (!row.phrase.empty()) phrases.push_back(row.phrase);
  return phrases;
}

/// The scope that the VS Code grammar gives to the start of a line: its first pattern that matches there, as
/// the editor takes the first of those that begin at one place. std::regex knows no look-behind, which only
/// says that commands begin a line.
class Colours {
 public:
  Colours() {
    const auto grammar = nlohmann::json::parse(make_vscode_files().back().text);
    for (const auto& pattern : grammar["patterns"]) {
      if (!pattern.contains("match")) continue;
      std::string text = pattern["match"];
      for (const char* unknown : {"(?i)", "(?<=^|;)", "(?<![A-Za-z_0-9])"}) {
        if (const auto at = text.find(unknown); at != std::string::npos)
          text.erase(at, std::string(unknown).size());
      }
      patterns_.emplace_back(pattern["name"], std::regex(text, std::regex::icase | std::regex::optimize));
    }
  }
  std::string of(const std::string& line) const {
    for (const auto& [scope, pattern] : patterns_) {
      std::smatch match;
      if (std::regex_search(line, match, pattern, std::regex_constants::match_continuous) &&
          match.length() == static_cast<std::ptrdiff_t>(line.size()))
        return scope;
    }
    return "";
  }

 private:
  std::vector<std::pair<std::string, std::regex>> patterns_;
};

}  // namespace

TEST_CASE("the grammar for VS Code colours every phrase of the rows", "[app][manual]") {
  const Colours colours;
  for (const TreeRow& entry : command_tree()) {
    for (const std::string& phrase : phrases_of(*entry.row)) {
      INFO(phrase);
      const std::string scope = colours.of((entry.row->is_block ? "Begin " : "") + phrase);
      if (entry.row->support == Support::supported && entry.row->is_block)
        CHECK(scope == "keyword.control.block.contactsim");
      else if (entry.row->support == Support::supported)
        CHECK(scope == "support.function.contactsim");
      else
        CHECK_FALSE(scope.empty());
    }
  }
  CHECK(colours.of("$ remark") == "comment.line.contactsim");
  CHECK(colours.of("1.5e-3") == "constant.numeric.contactsim");
  CHECK(colours.of("nonsense") == "");
}

TEST_CASE("the extension names the files that it has", "[app][manual]") {
  const std::vector<ManualFile> files = make_vscode_files();
  const auto package = nlohmann::json::parse(files.at(0).text);
  CHECK("./" + files.at(1).path == package["contributes"]["languages"][0]["configuration"]);
  CHECK("./" + files.at(2).path == package["contributes"]["grammars"][0]["path"]);
  CHECK(nlohmann::json::parse(files.at(1).text)["comments"]["lineComment"] == "#");
}
