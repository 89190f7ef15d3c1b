// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/deck_lines.hpp"

#include <map>

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

/// Lines as "begin words @line:column", a line each, then what is said.
std::string outlined(const std::string& text, const std::map<std::string, std::string>& files = {}) {
  const FileReader read_file = [&](const std::string& path) -> TextFile {
    const auto found = files.find(path);
    if (found != files.end()) return {found->second};
    return {"", "there is no such file", TextFile::Failure::missing};
  };
  Diagnostics said;
  std::string all;
  for (const DeckLine& line : read_deck_lines(make_source("a.i", text), said, read_file)) {
    if (line.kind != ParsedLine::Kind::command)
      all += line.kind == ParsedLine::Kind::begin ? "begin " : "end ";
    all += dump(line.command.words) + " @" + to_string(line.location) + "\n";
  }
  return all + messages(said);
}

}  // namespace

TEST_CASE("lines have their kind, their words and their place", "[parser][lines]") {
  CHECK(outlined("") == "");
  CHECK(outlined("\n # nothing\n$ nothing\n") == "");
  CHECK(outlined("  Begin block a\n x = 'b c', (d) # e\n end") ==
        "begin block a @a.i:1:3\nx [=] \"b c\" (d) @a.i:2:2\nend  @a.i:3:2\n");
  CHECK(outlined("BEGIN:\nENDS\n") == "BEGIN @a.i:1:1\nENDS @a.i:2:1\n");
}

TEST_CASE("a line of separators alone is none", "[parser][lines]") {
  CHECK(outlined(" , ,\nx\n") == "x @a.i:2:1\n");
  CHECK(outlined(":\n") == "");
}

TEST_CASE("words of a continued line stand where they were written", "[parser][lines]") {
  Diagnostics said;
  const auto lines = read_deck_lines(make_source("a.i", "a \\#\n  b(1, 2)\n"), said, read_no_file);
  REQUIRE(lines.size() == 1);
  const auto& words = lines[0].command.words;
  REQUIRE(words.size() == 2);
  CHECK(words[1].text == "b(1,2)");
  CHECK(to_string(words[1].location) == "a.i:2:3");
  CHECK(lines[0].command.text.substr(words[1].begin) == "b(1, 2)");
}

TEST_CASE("an included file stands in the place of its line", "[parser][lines]") {
  CHECK(outlined("a\nIncludeFile = b.i\nc\n", {{"b.i", "begin x\nincludefile 'd e'\n"}, {"d e", "y\n"}}) ==
        "a @a.i:1:1\nbegin x @b.i:1:1\ny @d e:1:1\nc @a.i:3:1\n");
  CHECK(outlined("includefile b.i\nincludefile b.i\n", {{"b.i", "x"}}) == "x @b.i:1:1\nx @b.i:1:1\n");
  CHECK(outlined("includefile b.i\n", {{"b.i", ""}}) == "");
}

TEST_CASE("an include that cannot be read is reported at its name, and passed over", "[parser][lines]") {
  CHECK(outlined("includefile none.i\nx\n") ==
        "x @a.i:2:1\na.i:1:13: error: cannot include 'none.i': there is no such file\n");
  CHECK(outlined("includefile ''\n") == "a.i:1:13: error: cannot include '': there is no such file\n");
  CHECK(outlined("includefile =\n") ==
        "a.i:1:1: error: INCLUDEFILE takes one file name; put a name with blanks in quotes\n");
  CHECK(outlined("includefile a b\n") ==
        "a.i:1:1: error: INCLUDEFILE takes one file name; put a name with blanks in quotes\n");
  CHECK(outlined("includefile sub/../a.i\n") ==
        "a.i:1:13: error: cannot include 'sub/../a.i': the file includes itself\n");
}

TEST_CASE("a problem in an included file tells the way to it", "[parser][lines]") {
  CHECK(outlined("\nincludefile b.i\n", {{"b.i", "includefile c.i\n"}}) ==
        "b.i:1:13: error: cannot include 'c.i': there is no such file\n  included from a.i:2\n");
}
