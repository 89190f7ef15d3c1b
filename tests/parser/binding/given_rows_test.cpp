// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/given_rows.hpp"

#include <list>

#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

/// A table of a required "mass" that may be given once, "note" and the choice of "red" or "green".
TableText given_table(const Choice& choice) {
  std::vector<RowText> rows(4);
  rows[0].phrase = "mass";
  rows[0].syntax = "= <real>";
  rows[0].is_required = rows[0].is_single = true;
  rows[1].phrase = "note";
  rows[2].phrase = "red";
  rows[3].phrase = "green";
  rows[2].choice = rows[3].choice = choice;
  return TableText(std::move(rows));
}

/// What is said of the lines of a car whose BEGIN is line 1.
std::string said_of_lines(const std::string& lines,
                          const Choice& choice = {"has no colour", "has two colours"}) {
  const TableText table = given_table(choice);
  const Block block = block_of("begin car\n" + lines + "end\n");
  const Block& car = std::get<Block>(block.items.at(0).value);
  Diagnostics said;
  DeckNames names;
  names.begin_block("car", std::nullopt, {"", car.location});
  GivenRows given(table);
  for (const Item& item : car.items) {
    const std::vector<Word>& words = std::get<Command>(item.value).words;
    const auto matched = table.commands.find(words);
    REQUIRE(matched);
    given.add(words, *matched, said);
  }
  given.check(names);
  names.end_block();
  names.resolve(said);
  names.report_problems_of_lines(said);
  return messages(said);
}

}  // namespace

TEST_CASE("a block whose rows are all given is nothing to tell", "[parser][table]") {
  CHECK(said_of_lines("mass = 1\nnote\nnote\ngreen\n") == "");
}

TEST_CASE("what is required or one of a choice and not given is reported at the block", "[parser][table]") {
  CHECK(said_of_lines("red\n") == "a.i:1:1: error: the car has no MASS; add MASS = <real>\n");
  CHECK(said_of_lines("mass = 1\n") == "a.i:1:1: error: the car has no colour; give it RED or GREEN\n");
  CHECK(said_of_lines("mass = 1\n", {"", "has two colours"}) == "");
}

TEST_CASE("several of a choice are reported at the last, with the first", "[parser][table]") {
  CHECK(said_of_lines("green\nmass = 1\nred\n") ==
        "a.i:4:1: error: the car has two colours; keep one of RED and GREEN; the first stands at a.i:2:1\n");
  CHECK(said_of_lines("mass = 1\ngreen\nred\n", {"has no colour", ""}) == "");
  CHECK(said_of_lines("mass = 1\nred\nred\n") == "");  // one row, given twice
}

TEST_CASE("a line that replaces an earlier one is warned about", "[parser][table]") {
  CHECK(said_of_lines("mass = 1\nred\nmass = 2\n") ==
        "a.i:4:1: warning: 'mass' is given twice in one block, this one counts; the other stands at a.i:2:1 "
        "[deck-repeated]\n");
}
