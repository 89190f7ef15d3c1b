// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/phrases.hpp"

#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

std::size_t match(const std::string& phrase, const std::string& line) {
  return match_phrase(split_phrase(phrase), command_of(line).words);
}

}  // namespace

TEST_CASE("a phrase is cut at blanks and underscores and put in lower case", "[parser][phrases]") {
  CHECK(split_phrase("Node_SET") == std::vector<std::string>{"node", "set"});
  CHECK(split_phrase("include all blocks") == std::vector<std::string>{"include", "all", "blocks"});
  CHECK(split_phrase("_a__b_") == std::vector<std::string>{"a", "b"});
  CHECK(split_phrase("").empty());
}

TEST_CASE("a line begins with a phrase whatever its case and underscores", "[parser][phrases]") {
  CHECK(match("node set", "NODE SET = a") == 2);
  CHECK(match("node set", "node_set = a") == 1);
  CHECK(match("pv_dependent model", "pv dependent_MODEL m") == 2);
}

TEST_CASE("a phrase matches whole words only", "[parser][phrases]") {
  CHECK(match("node set", "node sets = a") == 0);
  CHECK(match("elastic", "elastic_plastic") == 0);
  CHECK(match("node set", "node") == 0);
  CHECK(match("node set", "node \"set\"") == 0);
}

TEST_CASE("the longest phrase is found", "[parser][phrases]") {
  const std::vector<std::string> phrases{"time increment", "time", "", "time increment function"};
  const PhraseIndex index(phrases);
  const auto find = [&](const std::string& line) { return index.find(command_of(line).words); };
  CHECK(find("time increment = 3")->phrase == 0);
  CHECK(find("TIME_INCREMENT function = f")->phrase == 3);
  CHECK(find("TIME_INCREMENT function = f")->n_words == 2);
  CHECK(find("time is up")->phrase == 1);
  CHECK_FALSE(find("times = 3"));
}

TEST_CASE("the first of two equal phrases is found", "[parser][phrases]") {
  const std::vector<std::string> phrases{"scale factor", "scale_factor"};
  CHECK(PhraseIndex(phrases).find(command_of("scale factor = 1").words)->phrase == 0);
}

TEST_CASE("the nearest phrase is offered only when it is near", "[parser][phrases]") {
  const std::vector<std::string> phrases{"friction coefficient", "capture tolerance"};
  const PhraseIndex index(phrases);
  CHECK(index.nearest(command_of("fricton coeficient = 0.3").words) == "friction coefficient");
  CHECK(index.nearest(command_of("frictioncoefficient = 0.3").words) == "friction coefficient");
  CHECK(index.nearest(command_of("something else").words) == "");
}
