// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "app/manual/grammars.hpp"
#include "app/manual/phrase_pattern.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

TEST_CASE("the syntax of Vim has every phrase, the longest first", "[app][manual]") {
  const std::vector<ManualFile> files = make_vim_files();
  const std::string& syntax = files.at(0).text;
  const PhraseSets sets = phrase_sets();
  for (const auto* set : {&sets.blocks, &sets.commands, &sets.ignored, &sets.refused}) {
    CHECK_FALSE(set->empty());
    CHECK(std::is_sorted(set->begin(), set->end(),
                         [](const auto& a, const auto& b) { return a.size() > b.size(); }));
    for (const std::string& phrase : *set)
      CHECK_THAT(syntax, Contains(phrase_pattern({phrase}, "[ _\\t]\\+", "")));
  }
}

TEST_CASE("the files of Vim are where it looks for them", "[app][manual]") {
  std::vector<std::string> paths;
  for (const ManualFile& file : make_vim_files()) paths.push_back(file.path);
  CHECK(paths == std::vector<std::string>{"syntax/contactsim.vim", "ftdetect/contactsim.vim",
                                          "ftplugin/contactsim.vim"});
}
