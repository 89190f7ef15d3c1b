// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/lines.hpp"

#include <fmt/format.h>

#include "parser/text/syntax.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

/// The commands of a text, one a line, without any complaint.
std::string words(const std::string& text) {
  Diagnostics diagnostics;
  const Block deck = parse_syntax(make_source("a.i", text), diagnostics, read_no_file);
  CHECK(messages(diagnostics) == "");
  return dump(deck);
}

std::string line_errors(const std::string& text) {
  Diagnostics diagnostics;
  parse_syntax(make_source("a.i", text), diagnostics, read_no_file);
  return messages(diagnostics);
}

}  // namespace

TEST_CASE("a joined line keeps the offset of every character", "[parser][lines]") {
  const std::string text = "# head\nab \\# more\n  cd \"e\\#\nf\" # tail\n";
  const Source source = make_source("a.i", text);
  Diagnostics diagnostics;
  LineReader reader(source, diagnostics);
  LogicalLine line;
  REQUIRE(reader.next(line));
  CHECK(line.text == "ab    cd \"ef\" ");
  for (std::size_t i = 0; i < line.text.size(); ++i) {
    if (line.text[i] != ' ') CHECK(text[line.source_offset(i)] == line.text[i]);
  }
  REQUIRE(line.quotes.size() == 1);
  CHECK(line.text.substr(line.quotes[0].open, line.quotes[0].close - line.quotes[0].open + 1) == "\"ef\"");
  CHECK_FALSE(reader.next(line));
}

TEST_CASE("blanks, tabs and commas separate words", "[parser][lines]") {
  CHECK(words("at time 0, increment\t1") == "at time 0 increment 1\n");
  CHECK(words("0.5,2.0\n , \n\t\n,1,,2,\n") == "0.5 2.0\n1 2\n");
}

TEST_CASE("symbols are words of their own and need no blanks", "[parser][lines]") {
  CHECK(words("a=1\nb<=2\nc>=3\nd<4\ne>5\nf==6\ng = = 7") ==
        "a [=] 1\nb [<=] 2\nc [>=] 3\nd [<] 4\ne [>] 5\nf [==] 6\ng [=] [=] 7\n");
}

TEST_CASE("a comment runs from # or $ to the line's end", "[parser][lines]") {
  CHECK(words("# a\n$ b\n###\n x # c = 1\ny$d\nz#") == "x\ny\nz\n");
}

TEST_CASE("inside quotes # and $ are ordinary", "[parser][lines]") {
  CHECK(words("e \"a # b $ c\" # d") == "e \"a # b $ c\"\n");
  CHECK(words("e 'a # b'") == "e \"a # b\"\n");
}

TEST_CASE("a backslash before # or $ continues the line and hides what follows", "[parser][lines]") {
  CHECK(words("a \\#\nb \\$   \n c\\# comment\nd\ne") == "a b c d\ne\n");
  CHECK(words("a \\#\r\nb\r\n") == "a b\n");
  CHECK(words("a \\#") == "a\n");
}

TEST_CASE("other backslashes are ordinary", "[parser][lines]") {
  CHECK(words("f = c:\\mesh\\") == "f [=] c:\\mesh\\\n");
}

TEST_CASE("a commented continuation does not swallow the next line", "[parser][lines]") {
  CHECK(words("a # b \\#\nc") == "a\nc\n");
}

TEST_CASE("a double-quoted string may be continued, nothing taking the place of the line end",
          "[parser][lines]") {
  CHECK(words("e = \"x + \\#\n  y\\$ \nz\" w") == "e [=] \"x +   yz\" w\n");
  CHECK(words("e = \"a \\# b\" c") == "e [=] \"a \\# b\" c\n");
}

TEST_CASE("quotes may be empty and need no = before them", "[parser][lines]") {
  CHECK(words("timestamp format ''\nstamp=\"\"\nevaluate expression\"x\"") ==
        "timestamp format \"\"\nstamp [=] \"\"\nevaluate expression \"x\"\n");
}

TEST_CASE("an apostrophe inside a word is no quote, nor is one that nothing closes", "[parser][lines]") {
  CHECK(words("title Bob's run # it's") == "title Bob's run\n");
  CHECK(words("title rock 'n roll") == "title rock 'n roll\n");
  CHECK(words("title a 12\" pipe") == "title a 12\" pipe\n");
}

TEST_CASE("a double quote that is never closed is an error at the quote, once", "[parser][lines]") {
  CHECK(
      line_errors("e = \"x + 1\nf = 2\n") ==
      "a.i:1:5: error: the quote \" is never closed; close it, or end the line with \\# to go on in the next "
      "one\n");
}

TEST_CASE("commas and blanks in parentheses belong to the word before", "[parser][lines]") {
  CHECK(words("element stress(xx,1) as s, v( : , 2 ) v(*)") == "element stress(xx,1) as s v(:,2) v(*)\n");
  CHECK(words("title Puck (first, try)") == "title Puck (first try)\n");
  CHECK(words("a f(x b\nc g)x\nd h((1),2)") == "a f(x b\nc g)x\nd h((1) 2)\n");
}

TEST_CASE("a colon behind a keyword is dropped, others stay", "[parser][lines]") {
  CHECK(words("expression variable: v = nodal x\nvariable : v\nparameter:= 2\nlast:\nat 10:30 a::b") ==
        "expression variable v [=] nodal x\nvariable v\nparameter [=] 2\nlast\nat 10:30 a::b\n");
}

TEST_CASE("line ends may be CRLF and the last may be missing", "[parser][lines]") {
  CHECK(words("a 1\r\n\r\nb # c\r\nd \"e\"\r") == "a 1\nb\nd \"e\"\n");
}

TEST_CASE("text beyond ASCII may stand anywhere", "[parser][lines]") {
  CHECK(words("title M\xC3\xBCller \xE2\x82\xAC # \xC3\xA9") == "title M\xC3\xBCller \xE2\x82\xAC\n");
}

TEST_CASE("control characters are errors, one message for all alike", "[parser][lines]") {
  CHECK(line_errors(std::string("a\0b\n\x01 c\rd\n\0", 11)) ==
        "a.i:1:2: error: control character 0x00 in the deck\n  1 more like this, at a.i:3:1\n"
        "a.i:2:1: error: control character 0x01 in the deck\n"
        "a.i:2:4: error: control character 0x0d in the deck\n");
  Diagnostics diagnostics;
  parse_syntax(make_source("a.i", std::string(100000, '\x02')), diagnostics, read_no_file);
  CHECK(diagnostics.all().size() == 100);
}

TEST_CASE("a very long line takes linear time", "[parser][lines]") {
  const std::string unit = GENERATE("(", "a(", "\" ", "' ", "\"\\#", "'", "\\#", "=", "a:", "),");
  std::string text = "x ";
  for (int i = 0; i < 300000; ++i) text += unit;
  Diagnostics diagnostics;
  const Block deck = parse_syntax(make_source("a.i", text), diagnostics, read_no_file);
  CHECK(deck.items.size() == 1);
}
