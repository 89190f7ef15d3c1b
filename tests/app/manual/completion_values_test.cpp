// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/completion_values.hpp"

#include <sstream>

#include "app/manual/sample_commands.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::sample_commands;

TEST_CASE("what may stand for a value shows by its word", "[app][manual]") {
  const auto completes = [](const std::string& value) { return completion_of({{"--x"}, value, ""}); };
  CHECK(completes("DECK") == Completes::deck);
  CHECK(completes("MESH") == Completes::mesh);
  CHECK(completes("FILE") == Completes::file);
  CHECK(completes("A") == Completes::file);
  CHECK(completes("B") == Completes::file);
  CHECK(completes("FOLDER") == Completes::folder);
  CHECK(completes("WORDS") == Completes::phrases);
  CHECK(completes("N") == Completes::nothing);
  CHECK(completes("") == Completes::nothing);
  CHECK(completion_of({{}, "FILE", "", false, {"up", "down"}}) == Completes::words);
}

TEST_CASE("names of options and subcommands stand in a row", "[app][manual]") {
  CHECK(names_of(sample_commands()[0].options) == "-o --output --quiet");
  CHECK(names_of({}) == "");
  CHECK(subcommands_of(sample_commands()) == "sort");
  CHECK(subcommands_of({sample_commands()[0], sample_commands()[1], sample_commands()[1]}) == "sort sort");
}

TEST_CASE("words of phrases are in alphabetical order, each once and in lower case", "[app][manual]") {
  std::istringstream words(phrase_words());
  std::string last;
  std::size_t n = 0;
  for (std::string word; words >> word; ++n) {
    CHECK(last < word);
    CHECK(std::none_of(word.begin(), word.end(), [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; }));
    last = word;
  }
  CHECK(n > 300);
}
