// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/inp_lines.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Cells = std::vector<std::string>;

/// A file with this text, gone through line by line.
struct InpText {
  explicit InpText(const std::string& text) { write_bytes(directory.file("a.inp"), text); }
  TemporaryDirectory directory;
};

/// Keywords and data lines as "NAME:line" and "cell|cell", a blank between them.
std::string outline(const std::string& text) {
  const InpText file(text);
  InpLines lines(file.directory.file("a.inp"));
  std::string all;
  InpKeyword keyword;
  Cells cells;
  while (lines.next_keyword(keyword)) {
    all += keyword.name + ":" + std::to_string(keyword.line) + " ";
    while (lines.next_data(cells)) {
      std::string row;
      for (const std::string& cell : cells) row += (row.empty() ? "" : "|") + cell;
      all += row + " ";
    }
  }
  return all;
}

}  // namespace

TEST_CASE("keyword lines go on behind a comma, parameters ignore case", "[io][import]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("l.inp"), "*Surface, name=\"A b\",\n Type=Element\n1, S1,\n**x\n2, S2\n*End");
  InpLines lines(directory.file("l.inp"));
  InpKeyword keyword;
  REQUIRE(lines.next_keyword(keyword));
  CHECK(keyword.name == "SURFACE");
  CHECK(keyword.value("NAME") == "A b");
  CHECK(keyword.value("TYPE") == "Element");
  std::vector<std::string> cells;
  REQUIRE(lines.next_data(cells));
  CHECK(cells == std::vector<std::string>{"1", "S1"});
  REQUIRE(lines.next_data(cells));
  CHECK_FALSE(lines.next_data(cells));
  REQUIRE(lines.next_keyword(keyword));
  CHECK_FALSE(lines.next_keyword(keyword));
}

TEST_CASE("cells are what stands between commas, without blanks around them", "[io][import]") {
  CHECK(split_cells("1, 2.5 ,\tset a\t") == Cells{"1", "2.5", "set a"});
  CHECK(split_cells("1, 2,") == Cells{"1", "2"});
  CHECK(split_cells("1,,2") == Cells{"1", "", "2"});
  CHECK(split_cells(",1") == Cells{"", "1"});
  CHECK(split_cells("one") == Cells{"one"});
  CHECK(split_cells("a\r") == Cells{"a"});
  CHECK(split_cells("").empty());
  CHECK(split_cells(" \t\r").empty());
}

TEST_CASE("comments, empty lines and line ends of Windows are no data", "[io][import]") {
  CHECK(outline("** head\n*A\n1, 2\n\n** between\n3\n*b\n") == "A:2 1|2 3 B:7 ");
  CHECK(outline("*A\r\n1,2\r\n\r\n**\r\n*B, x=1\r\n") == "A:1 1|2 B:5 ");
  CHECK(outline("") == "");
  CHECK(outline("** all comment") == "");
}

TEST_CASE("data before the first keyword, or that nobody asks for, is passed over", "[io][import]") {
  CHECK(outline("stray\n*A\n1\n") == "A:2 1 ");
  const InpText file("*A\n1\n2\n*B\n3");
  InpLines lines(file.directory.file("a.inp"));
  InpKeyword keyword;
  REQUIRE(lines.next_keyword(keyword));
  REQUIRE(lines.next_keyword(keyword));
  CHECK(keyword.name == "B");
  Cells cells;
  REQUIRE(lines.next_data(cells));
  CHECK(cells == Cells{"3"});
}

TEST_CASE("a keyword has its parameters with or without a value, the last of a name counts", "[io][import]") {
  const InpText file("*  Solid Section , ELSET = My Set, Generate,a=1,A=\"\"\n");
  InpLines lines(file.directory.file("a.inp"));
  InpKeyword keyword;
  REQUIRE(lines.next_keyword(keyword));
  CHECK(keyword.name == "SOLID SECTION");
  CHECK(keyword.value("ELSET") == "My Set");
  CHECK(keyword.has("GENERATE"));
  CHECK(keyword.value("GENERATE") == "");
  CHECK(keyword.has("A"));
  CHECK(keyword.value("A") == "");
  CHECK_FALSE(keyword.has("elset"));
  CHECK(keyword.value("NAME") == "");
  CHECK(keyword.line == 1);
}

TEST_CASE("a comma at the end of a keyword line does not reach over the next keyword", "[io][import]") {
  CHECK(outline("*A,\n*B,\n** c\nx=1\n2\n") == "A:1 B:2 2 ");
  CHECK(outline("*A,") == "A:1 ");
  CHECK(outline("*") == ":1 ");
}

TEST_CASE("messages of an input file have the line of what was read last", "[io][import]") {
  const InpText file("*A\n1\n\n2\n*B\n");
  InpLines lines(file.directory.file("a.inp"));
  InpKeyword keyword;
  Cells cells;
  REQUIRE(lines.next_keyword(keyword));
  REQUIRE(lines.next_data(cells));
  CHECK(lines.words().line_number() == 2);
  REQUIRE(lines.next_data(cells));
  CHECK(lines.words().line_number() == 4);
  CHECK_THROWS_WITH(lines.words().fail("so"), file.directory.file("a.inp") + ": line 4: so");
}
