// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/text_table.hpp"

#include <algorithm>
#include <sstream>

#include "app/reports/wrap_text.hpp"
#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using contactsim::test::ProgramDirectory;

namespace {

/// The longest line of a text, of which a word alone may be longer than a line should be.
std::size_t widest_line(const std::string& text, std::size_t longest_word) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::size_t longest = 0;
    for (std::string word; words >> word;) longest = std::max(longest, n_columns(word));
    if (longest <= longest_word) widest = std::max(widest, n_columns(line));
  }
  return widest;
}

TextTable pairs_of_numbers(std::size_t n_numbers) {
  std::vector<TextTable::Column> columns{name_column("part", 20)};
  for (std::size_t i = 0; i < n_numbers; ++i) columns.push_back({fmt::format("upper\nn{}", i), 24});
  return {2, 1, std::move(columns)};
}

}  // namespace

TEST_CASE("columns that do not fit stand in a further part behind the first ones", "[app][table]") {
  TextTable table = pairs_of_numbers(5);
  table.add("lid", 1, 2, 3, 4, 5);
  CHECK(table.format() ==
        "                                          upper                    upper                    upper\n"
        "  part                                       n0                       n1                       n2\n"
        "  lid                                         1                        2                        3\n"
        "\n"
        "                                          upper                    upper\n"
        "  part                                       n3                       n4\n"
        "  lid                                         4                        5\n");
}

TEST_CASE("what follows a long name stands on the next line, and names stay whole", "[app][table]") {
  TextTable table(0, 2, {{"no", 4}, name_column("first", 20), name_column("second", 20), {"faces", 6}});
  const std::string first(70, 'a'), second(90, 'b');
  table.add(1, first, second, 12);
  table.add(2, "lid", "box", 3);
  CHECK(table.format() ==
        "  no  first                 second                faces\n"
        "   1  " +
            first + "\n" + std::string(28, ' ') + second + "\n" + std::string(53, ' ') +
            "12\n"
            "   2  lid                   box                       3\n");
}

TEST_CASE("text at the end of a row is broken at blanks under itself", "[app][table]") {
  TextTable table(6, 1, {name_column("id", 28), text_column("text")});
  std::string words;
  for (int i = 0; i < 30; ++i) words += fmt::format("word{} ", i);
  table.add("surface-overlap", words + "end");
  std::istringstream lines(table.format());
  std::string line, joined;
  std::getline(lines, line);
  for (std::size_t i = 0; std::getline(lines, line); ++i) {
    CHECK(line.size() <= line_width);
    CHECK(line.find_first_not_of(' ') == (i == 0 ? 6 : 36));
    joined += line.substr(36) + " ";
  }
  CHECK(joined == words + "end ");
}

TEST_CASE("no line of tables, checks and runs is longer than 120 columns", "[app][table]") {
  const std::string deck = GENERATE("two_blocks", "impact", "taylor_bar");
  const ProgramDirectory directory;
  directory.copy_decks({deck + ".i", deck + ".g"});
  std::vector<std::string> stages{"--tables", "--check"};
  if (deck == "two_blocks") stages.push_back("--quiet");
  for (const std::string& stage : stages) {
    INFO(deck << " " << stage);
    const auto [code, out, err] = directory.run({deck + ".i", stage});
    CHECK(code == 0);
    CHECK(widest_line(out, 200) <= line_width);
    const std::string log = directory.read(deck + ".log");
    CHECK(widest_line(log, 200) <= line_width);
    CHECK(widest_line(log, 200) > 60);
  }
}

TEST_CASE("long names of surfaces make no long lines but of themselves", "[app][table]") {
  const ProgramDirectory directory;
  directory.copy_decks({"two_blocks.g"});
  const std::string first = "outer_" + std::string(60, 'a'), second = "inner_" + std::string(140, 'b');
  directory.write("a.i", "begin contact definition\ncontact surface " + first + " contains left\n" +
                             "contact surface " + second + " contains right\n" +
                             "contact surface third contains left\nbegin interaction " + second +
                             "\nsurfaces = " + first + " " + second + "\nend\nend\n");
  const auto [code, out, err] = directory.run({"a.i", "two_blocks.g", "--check"});
  CHECK(err.find("error") == std::string::npos);
  REQUIRE(code == 0);
  CHECK(widest_line(out, 60) <= line_width);
  CHECK(widest_line(directory.read("a.log"), 60) <= line_width);
  CHECK(out.find(first) != std::string::npos);
  CHECK(out.find(second) != std::string::npos);
}
