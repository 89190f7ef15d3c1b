// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/table_text.hpp"

#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

const Choice one_colour{"has no colour", "has two colours"};

RowText row_called(const std::string& phrase) {
  RowText row;
  row.phrase = phrase;
  return row;
}

RowText of_choice(const std::string& phrase) {
  RowText row = row_called(phrase);
  row.choice = one_colour;
  return row;
}

/// Commands "size", "size of all" (spelled "whole size", too), a required "mass", two of a choice, a block
/// "part", lines of numbers.
TableText sample_table() {
  RowText of_all = row_called("size of all");
  of_all.spellings = {"whole size"};
  RowText mass = row_called("mass");
  mass.is_required = true;
  RowText part = row_called("part");
  part.is_block = true;
  RowText numbers;
  numbers.matches = RowText::Matches::numbers;
  return TableText(
      {row_called("size"), of_all, mass, of_choice("red"), part, of_choice("dark green"), numbers});
}

std::optional<MatchedItem> found_by(const RowPhrases& phrases, const std::string& line) {
  const Command command = command_of(line);
  return phrases.find(command.words);
}

}  // namespace

TEST_CASE("a row as a deck would have it has its keywords in capitals", "[parser][rows]") {
  RowText row = row_called("friction coefficient");
  CHECK(deck_form_of(row) == "FRICTION COEFFICIENT");
  row.syntax = "= <real >= 0>";
  CHECK(deck_form_of(row) == "FRICTION COEFFICIENT = <real >= 0>");
  row.syntax = ": <name>";
  CHECK(deck_form_of(row) == "FRICTION COEFFICIENT: <name>");
  row.syntax = "<name>";
  row.is_block = true;
  CHECK(deck_form_of(row) == "BEGIN FRICTION COEFFICIENT <name>");
  RowText numbers;
  numbers.syntax = "<x> <y>";
  CHECK(deck_form_of(numbers) == "<x> <y>");
}

TEST_CASE("the dimensions of a row stand in the brackets of its help", "[parser][rows]") {
  RowText row = row_called("x");
  const auto dimension = [&](const std::string& help) {
    row.help = help;
    return dimension_of(row);
  };
  CHECK(dimension("A name") == "");
  CHECK(dimension("Coulomb coefficient [1]") == "1");
  CHECK(dimension("Of speed [length/time] and way [length]") == "length/time, length");
  CHECK(dimension("[time]") == "time");
}

TEST_CASE("phrases of a choice are listed in the order of the rows", "[parser][rows]") {
  const TableText table = sample_table();
  CHECK(phrases_of_choice(table, one_colour, "or") == "RED or DARK GREEN");
  CHECK(phrases_of_choice(table, {"other", ""}, "and") == "");
  CHECK(phrases_of_choice(TableText({of_choice("a")}), one_colour, "and") == "A");
  CHECK(phrases_of_choice(TableText({of_choice("a"), of_choice("b"), of_choice("c")}), one_colour, "and") ==
        "A, B and C");
}

TEST_CASE("the longest phrase or spelling leads to its row", "[parser][rows]") {
  const TableText table = sample_table();
  const auto row_of = [&](const std::string& line) -> int {
    const auto found = found_by(table.commands, line);
    return found ? static_cast<int>(found->row) : -1;
  };
  CHECK(row_of("size = 3") == 0);
  CHECK(row_of("SIZE_OF all = 3") == 1);
  CHECK(row_of("whole size = 3") == 1);
  CHECK(found_by(table.commands, "whole size = 3")->n_words == 2);
  CHECK(row_of("size of = 3") == 0);
  CHECK(row_of("dark green") == 5);
  CHECK(row_of("part a") == -1);  // a block
  CHECK(row_of("1 2") == -1);
  CHECK(found_by(table.blocks, "part a")->row == 4);
  CHECK_FALSE(found_by(table.blocks, "size a"));
  CHECK(table.commands.nearest(command_of("sise = 3").words) == "size");
  CHECK(table.commands.nearest(command_of("elephant = 3").words) == "");
}

TEST_CASE("a table knows what is needed of it, and its rows without phrases", "[parser][rows]") {
  const TableText table = sample_table();
  CHECK(table.needed == std::vector<std::size_t>{2, 3, 5});
  CHECK(table.numbers_row == 6);
  CHECK(table.anything_row == table.rows.size());
  const TableText empty({});
  CHECK(empty.numbers_row == 0);
  CHECK(empty.needed.empty());
}
