// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/deck_sections.hpp"

#include <set>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("sections hold each row once, under the block in which it stands", "[app][manual]") {
  std::size_t n_rows = 0;
  for (const DeckSection& section : deck_sections()) {
    for (const TreeRow* row : section.rows) CHECK(row->around == section.around);
    n_rows += section.rows.size();
  }
  CHECK(n_rows == command_tree().size());
}

TEST_CASE("each block has one section, the top of a deck the first", "[app][manual]") {
  const std::vector<DeckSection> sections = deck_sections();
  CHECK(sections.front().around.empty());
  std::set<std::vector<const RowText*>> blocks;
  for (const DeckSection& section : sections) {
    CHECK(blocks.insert(section.around).second);
    CHECK_FALSE(section.rows.empty());
  }
}
