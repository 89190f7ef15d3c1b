// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/run.hpp"

#include "support/expanded_deck.hpp"

using namespace contactsim;

TEST_CASE("if, elseif and else choose lines; the control lines go away", "[parser][aprepro]") {
  const std::string deck =
      "{{n = N}}top\n"
      "  {if(n == 1)}\none\n"
      "  {elseif(n == 2)} \t\ntwo\n"
      "  {else} not kept\nmany\n"
      "  {endif} not kept\n"
      "bottom\n";
  const auto choose = [&](const std::string& n) {
    std::string with = deck;
    return expanded_text(with.replace(with.find('N'), 1, n));
  };
  CHECK(choose("1") == "top\none\nbottom\n");
  CHECK(choose("2") == "top\n \ttwo\nbottom\n");
  CHECK(choose("3") == "top\nmany\nbottom\n");
}

TEST_CASE("ifs nest, and what is skipped is not evaluated", "[parser][aprepro]") {
  CHECK(expanded_text(
            "{if(0)}\n{x = 1/0}{if(1)}\na\n{else}\nb\n{endif}\n{else}\n{if(1)}\nc\n{endif}\n{endif}\nd\n") ==
        "c\nd\n");
}

TEST_CASE("ifdef and ifndef ask whether a name is set to something other than 0", "[parser][aprepro]") {
  const auto defined = [](const std::string& set) {
    return expanded_text(set + "{ifdef(x)}\nyes\n{else}\nno\n{endif}\n{ifndef(x)}\nunset\n{endif}\n");
  };
  CHECK(defined("") == "no\nunset\n");
  CHECK(defined("{{x = 0}}") == "no\nunset\n");
  CHECK(defined("{{x = 2}}") == "yes\n");
  CHECK(defined("{{x = \"\"}}") == "no\nunset\n");
}

TEST_CASE("switch takes the first case that is equal, or default", "[parser][aprepro]") {
  const auto choose = [](const std::string& value) {
    return expanded_text(
        "{switch(" + value +
        ")} dropped\ndropped {x = 1/0}\n{case(1)}\none\n{case(\"b\")}\nbee\n{case(1)}\nagain\n{default}\n"
        "other\n{endswitch}\nend\n");
  };
  CHECK(choose("1") == "one\nend\n");
  CHECK(choose("\"b\"") == "bee\nend\n");
  CHECK(choose("5") == "other\nend\n");
  CHECK(expanded_text("{switch(2)}\n{case(1)}\none\n{endswitch}\nend\n") == "end\n");
}

TEST_CASE("ECHO switches the output off and on, but not the evaluation", "[parser][aprepro]") {
  CHECK(expanded_text("a {ECHO(OFF)}\nhidden {x = 3}\n{ECHO(ON)}b {x}\n") == "ab 3\n");
  CHECK(expanded_text("{NOECHO}a{ECHO}b\n") == "b\n");
  CHECK(expanded_text("{include(b.i)}\nshown\n", {{"b.i", "x{ECHO(OFF)}\nhidden\n"}}) == "x\nshown\n");
}

TEST_CASE("IMMUTABLE guards the variables that are made after it, up to the end of the file",
          "[parser][aprepro]") {
  const Expanded expanded = expand("{IMMUTABLE(ON)}{a = 1}{IMMUTABLE(OFF)} {a = 2} {b = 1} {b = 2}\n");
  CHECK(expanded.source.text() == "1 1 1 2\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:1:41: warning: 'a' stays 1, as it is immutable [aprepro-immutable]\n");
  CHECK(expanded_text("{include(b.i)}\n{x = 2}{x = 3}\n", {{"b.i", "{IMMUTABLE(ON)}\n"}}) == "\n23\n");
}

TEST_CASE("copied text keeps its place and a value has that of its brace", "[parser][aprepro]") {
  const Expanded expanded = expand("ab {10*10} cd\n");
  REQUIRE(expanded.source.text() == "ab 100 cd\n");
  CHECK(expanded.source.locate(1).column == 2);
  CHECK(expanded.source.locate(3).column == 4);
  CHECK(expanded.source.locate(5).column == 4);
  CHECK(expanded.source.locate(7).column == 12);
}

TEST_CASE("problems stand at their character, once for all passes, and do not stop the deck",
          "[parser][aprepro]") {
  const Expanded expanded = expand("{loop(3)}\nx = {sqr(2)} {y}\n{endloop}\n{1 +} {s = \"a\nb}\nz {2}\n");
  CHECK(expanded.source.text() == "x = 1 0\nx = 1 0\nx = 1 0\n1 1\nz 2\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:2:6: error: unknown function 'sqr'; did you mean 'sqrt'?\n"
        "  pass 1 of 3 of the loop at a.i:1:1\n"
        "a.i:2:15: error: 'y' is not defined\n"
        "  pass 1 of 3 of the loop at a.i:1:1\n"
        "a.i:4:5: error: expected a value, found the end of the expression\n"
        "a.i:4:12: error: the string \" is never closed; only a string in '...' may span lines\n");
}

TEST_CASE("a brace that nothing closes costs its line only", "[parser][aprepro]") {
  const Expanded expanded = expand("a {x + 1\nb {2}\n{{3}\nc\n");
  CHECK(expanded.source.text() == "a 1\nb 2\n1\nc\n");
  CHECK(expanded.diagnostics.error_count() == 2);
  CHECK(expansion_problems("a {x").starts_with("a.i:1:3: error: nothing closes this brace; write \\{"));
}

TEST_CASE("a deck that expands without end is stopped with an error", "[parser][aprepro][slow]") {
  const auto stopped_by = [](const std::string& text, const FileReader& read_file = read_no_file) {
    Diagnostics found;
    try {
      run_aprepro(make_source("a.i", text), {{}, read_file}, found);
    } catch (const DeckError& error) {
      return messages(error.diagnostics());
    }
    return messages(found);
  };
  CHECK(stopped_by("{loop(1000000)}\n{loop(1000000)}\n{endloop}\n{endloop}\n")
            .find("more than a million passes") != std::string::npos);
  CHECK(
      stopped_by("{{s = \"0123456789\"}}{loop(16)}\n{{s = s // s}}{endloop}\n{loop(999999)}\n{s}{endloop}\n")
          .find("expands without end") != std::string::npos);
  CHECK(stopped_by("{loop(1000000)}\n{__loop_1 < 0 ? 1 : 2} and some more text that makes the deck grow ever "
                   "on, until it is larger than any deck that is made by hand, or "
                   "by a script that is in its right mind\n"
                   "{endloop}\n")
            .find("expands without end") != std::string::npos);
  std::string wrong;
  for (int i = 0; i < 300; ++i) wrong += "{nosuch(1)}\n";
  CHECK(stopped_by(wrong).find("too many problems with Aprepro") != std::string::npos);
  const auto endless = [](const std::string& path) -> TextFile { return {"{include(" + path + "x)}\n"}; };
  CHECK(stopped_by("{include(x)}\n", endless).find("nested more than 32 deep") != std::string::npos);
  const auto twice = [](const std::string& path) -> TextFile {
    return {"{include(" + path + "x)}\n{include(" + path + "y)}\n"};
  };
  CHECK(stopped_by("{include(x)}\n", twice).find("too many") != std::string::npos);
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "{if(1)}\n";
  CHECK(stopped_by(deep).find("nested more than 64 deep") != std::string::npos);
}
