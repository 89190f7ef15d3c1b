// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/phrase_pattern.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

bool has_phrase(const std::vector<std::string>& set, const std::string& phrase) {
  return std::find(set.begin(), set.end(), phrase) != set.end();
}

}  // namespace

TEST_CASE("phrases become alternatives whose words are parted", "[app][manual]") {
  CHECK(phrase_pattern({"a b", "c"}, "_", "|") == "a_b|c");
  CHECK(phrase_pattern({"begin a_b"}, "[ _]+", "|") == "begin[ _]+a[ _]+b");
  CHECK(phrase_pattern({}, "_", "|") == "");
}

TEST_CASE("each phrase stands in one set, spellings too, blocks behind BEGIN", "[app][manual]") {
  const PhraseSets sets = phrase_sets();
  CHECK(has_phrase(sets.blocks, "begin contact definition"));
  CHECK(has_phrase(sets.commands, "friction coefficient"));
  CHECK(has_phrase(sets.commands, "components"));  // a spelling of COMPONENT
  CHECK(has_phrase(sets.refused, "node set subroutine"));
  CHECK(has_phrase(sets.ignored, "subroutine debugging"));
  std::vector<std::string> all;
  for (const auto* set : {&sets.blocks, &sets.commands, &sets.ignored, &sets.refused})
    all.insert(all.end(), set->begin(), set->end());
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}
