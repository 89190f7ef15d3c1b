// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/aprepro.hpp"

#include <map>
#include <string>
#include <vector>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

using Files = std::map<std::string, std::string>;

struct Expanded {
  Diagnostics diagnostics;
  Source source;
};

Expanded expand(const std::string& text, const Files& files = {},
                const std::vector<std::string>& overrides = {}) {
  const auto read_file = [&](const std::string& path) -> TextFile {
    const auto found = files.find(path);
    if (found != files.end()) return {found->second};
    return {"", "there is no such file", TextFile::Failure::missing};
  };
  Expanded expanded;
  try {
    expanded.source = run_aprepro(make_source("a.i", text), {overrides, read_file}, expanded.diagnostics);
  } catch (const DeckError&) {
    // What it carries is among the diagnostics already.
  }
  return expanded;
}

/// The expanded text, without any complaint.
std::string text_of(const std::string& text, const Files& files = {}) {
  const Expanded expanded = expand(text, files);
  CHECK(messages(expanded.diagnostics) == "");
  return expanded.source.text();
}

std::string problems(const std::string& text, const Files& files = {}) {
  return messages(expand(text, files).diagnostics);
}

}  // namespace

TEST_CASE("a deck without braces comes through untouched", "[parser][aprepro]") {
  const std::string deck = "begin a # it's \"so\" \\# \\\n\tx = 1\r\nend";
  CHECK(text_of(deck) == deck);
}

TEST_CASE("expressions are replaced by their values everywhere, comments and quotes too",
          "[parser][aprepro]") {
  CHECK(text_of("# {dt = 1e-6}\nx = {2*dt} \"{dt}\" '{\"s\"}'\n") == "# 1e-06\nx = 2e-06 \"1e-06\" 's'\n");
}

TEST_CASE("double braces evaluate and print nothing, empty ones too", "[parser][aprepro]") {
  CHECK(text_of("a{{x = 2}}b{x}c{ }d{{}}e\n") == "ab2cde\n");
}

TEST_CASE("braces behind a backslash are literal", "[parser][aprepro]") {
  CHECK(text_of("\\{a\\} \\\\ {1}\n") == "{a} \\\\ 1\n");
  CHECK(text_of("only \\} here\n") == "only } here\n");
  CHECK(text_of("{1}}\n") == "1}\n");
}

TEST_CASE("an expression and a string in single quotes may span lines", "[parser][aprepro]") {
  CHECK(text_of("{ 1 +\n 2 }\n{s = 'two\nlines with }'}|\n") == "3\ntwo\nlines with }|\n");
}

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
    return text_of(with.replace(with.find('N'), 1, n));
  };
  CHECK(choose("1") == "top\none\nbottom\n");
  CHECK(choose("2") == "top\n \ttwo\nbottom\n");
  CHECK(choose("3") == "top\nmany\nbottom\n");
}

TEST_CASE("text behind an if is joined to the next line, which is warned about", "[parser][aprepro]") {
  const Expanded expanded = expand("{if(1)} x\ny\n{elseif(1)} not taken\n{endif}\n");
  CHECK(expanded.source.text() == " xy\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:1:9: warning: this text is joined to the next line, as the line end behind {if(1)} is dropped; "
        "put it on "
        "a line of its own [aprepro-joined]\n");
}

TEST_CASE("ifs nest, and what is skipped is not evaluated", "[parser][aprepro]") {
  CHECK(text_of(
            "{if(0)}\n{x = 1/0}{if(1)}\na\n{else}\nb\n{endif}\n{else}\n{if(1)}\nc\n{endif}\n{endif}\nd\n") ==
        "c\nd\n");
}

TEST_CASE("ifdef and ifndef ask whether a name is set to something other than 0", "[parser][aprepro]") {
  const auto defined = [](const std::string& set) {
    return text_of(set + "{ifdef(x)}\nyes\n{else}\nno\n{endif}\n{ifndef(x)}\nunset\n{endif}\n");
  };
  CHECK(defined("") == "no\nunset\n");
  CHECK(defined("{{x = 0}}") == "no\nunset\n");
  CHECK(defined("{{x = 2}}") == "yes\n");
  CHECK(defined("{{x = \"\"}}") == "no\nunset\n");
}

TEST_CASE("control words with an argument may be capitalised", "[parser][aprepro]") {
  CHECK(text_of("{Ifdef(x)}\na\n{Else}\nb\n{EndIf}\n{Loop(2)}\nc\n{EndLoop}\n") == "b\nc\nc\n");
  CHECK(text_of("{{Default = 3}}{Default} {{IF = 4}}{IF}\n") == "3 4\n");
}

TEST_CASE("switch takes the first case that is equal, or default", "[parser][aprepro]") {
  const auto choose = [](const std::string& value) {
    return text_of(
        "{switch(" + value +
        ")} dropped\ndropped {x = 1/0}\n{case(1)}\none\n{case(\"b\")}\nbee\n{case(1)}\nagain\n{default}\n"
        "other\n{endswitch}\nend\n");
  };
  CHECK(choose("1") == "one\nend\n");
  CHECK(choose("\"b\"") == "bee\nend\n");
  CHECK(choose("5") == "other\nend\n");
  CHECK(text_of("{switch(2)}\n{case(1)}\none\n{endswitch}\nend\n") == "end\n");
}

TEST_CASE("a loop repeats its lines and counts in a variable", "[parser][aprepro]") {
  CHECK(text_of("{loop(3)}\n{__loop_1}\n{endloop}\n") == "0\n1\n2\n");
  CHECK(text_of("{loop(2, i)}\n{i}\n{endloop}\n") == "0\n1\n");
  CHECK(text_of("{{n = 3}}{loop(n, i, 5, -2)} dropped\n  {i}\n  {endloop} dropped\n{i}\n") ==
        "  5\n  3\n  1\n1\n");
  CHECK(text_of("{loop(2, i, max(1, 2))}\n{i}\n{endloop}\n") == "2\n3\n");
}

TEST_CASE("loops nest, each with a variable of its own", "[parser][aprepro]") {
  CHECK(text_of("{loop(2)}\n{loop(2)}\n{__loop_1}{__loop_2}\n{endloop}\n{endloop}\n") == "00\n01\n10\n11\n");
}

TEST_CASE("a loop of no passes leaves nothing", "[parser][aprepro]") {
  CHECK(text_of("a\n{loop(0)}\n{x = 1/0}\n{endloop}\n{loop(-1)}\nb\n{endloop}\nc\n") == "a\nc\n");
}

TEST_CASE("an include puts a file in its place", "[parser][aprepro]") {
  const Files files = {{"b.i", "b {x}\n"}, {"c.i", "c {x = 2}"}, {"d e.i", "d\n"}};
  CHECK(text_of("{{x = 1}}{include(\"b.i\")}\na\n", files) == "b 1\na\n");
  CHECK(text_of("{include(c.i)}\n{include(b.i)}\n\nz\n", files) == "c 2\nb 2\nz\n");
  CHECK(text_of("{{f = \"d \" // \"e.i\"}}{include(f)}\n{include(\"d \" // 'e.i')}\n", files) == "d\nd\n");
  CHECK(text_of("v = {include(c.i)} end\n", files) == "v = c 2 end\n");
  CHECK(text_of("{cinclude(none.i)}\n{cinclude(\"d e.i\")}\n", files) == "d\n");
}

TEST_CASE("a comment mark with a blank behind it goes away before a control line", "[parser][aprepro]") {
  const Files files = {{"b.i", "live\n# dead\n"}};
  const std::string mark = GENERATE("#", "$", "//", "  #", "##");
  CHECK(text_of(mark + " {include(b.i)}\n", files) == "live\n# dead\n");
  CHECK(text_of(mark + " {if(1)}\na\n" + mark + " {else}\nb\n" + mark + "\t{endif}\nc\n") == "a\nc\n");
  CHECK(text_of(mark + " {loop(2)}\na\n" + mark + " {endloop}\nb\n") == "a\na\nb\n");
}

TEST_CASE("other marks and comments before a control line stay", "[parser][aprepro]") {
  CHECK(text_of("x # {if(1)}\n{endif}\n") == "x # ");
  CHECK(text_of("/ {if(1)}\n{endif}\n") == "/ ");
}

TEST_CASE("a comment mark glued to a control line hides the next line, which is warned about",
          "[parser][aprepro]") {
  const Expanded expanded = expand("#{if(1)}\nhidden\n#{endif}\nhidden too\n");
  CHECK(expanded.source.text() == "#hidden\n#hidden too\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:1:1: warning: this comment mark comes to stand before the next line and hides it; put a blank "
        "between "
        "the mark and the brace [aprepro-hidden]\n  1 more like this, at a.i:3:1\n");
  CHECK(text_of("#{include(b.i)}\nx\n", {{"b.i", "# head\nlive\n"}}) == "## head\nlive\nx\n");
  CHECK(problems("#{include(b.i)}\n", {{"b.i", "live\n"}}) ==
        "a.i:1:1: warning: this comment mark hides the first line of 'b.i'; put a blank between the mark and "
        "the "
        "brace [aprepro-hidden]\n");
}

TEST_CASE("{#} at the start of a line comments it out", "[parser][aprepro]") {
  CHECK(text_of("{#} {include(\"none\")} {\n {#}{x\na {1}\n") == "# {include(\"none\")} {\n #{x\na 1\n");
}

TEST_CASE("ECHO switches the output off and on, but not the evaluation", "[parser][aprepro]") {
  CHECK(text_of("a {ECHO(OFF)}\nhidden {x = 3}\n{ECHO(ON)}b {x}\n") == "ab 3\n");
  CHECK(text_of("{NOECHO}a{ECHO}b\n") == "b\n");
  CHECK(text_of("{include(b.i)}\nshown\n", {{"b.i", "x{ECHO(OFF)}\nhidden\n"}}) == "x\nshown\n");
}

TEST_CASE("VERBATIM and APREPRO switch the expansion off", "[parser][aprepro]") {
  CHECK(text_of("{VERBATIM(ON)}{a} {if(1)}\n{VERBATIM(OFF)}{1}\n") == "{a} {if(1)}\n1\n");
  CHECK(text_of("{APREPRO(OFF)}{a} {VERBATIM(OFF)}{APREPRO(ON)}{1}\n") == "{a} {VERBATIM(OFF)}1\n");
  CHECK(text_of("{VERBATIM(ON)}{to the end") == "{to the end");
}

TEST_CASE("IMMUTABLE guards the variables that are made after it, up to the end of the file",
          "[parser][aprepro]") {
  const Expanded expanded = expand("{IMMUTABLE(ON)}{a = 1}{IMMUTABLE(OFF)} {a = 2} {b = 1} {b = 2}\n");
  CHECK(expanded.source.text() == "1 1 1 2\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:1:41: warning: 'a' stays 1, as it is immutable [aprepro-immutable]\n");
  CHECK(text_of("{include(b.i)}\n{x = 2}{x = 3}\n", {{"b.i", "{IMMUTABLE(ON)}\n"}}) == "\n23\n");
}

TEST_CASE("variables from the command line hold against the deck's", "[parser][aprepro]") {
  const Expanded expanded =
      expand("{mu = 0.3} {mu} {name} {n + 1}\n", {}, {"mu=0.1", "name=steel", "n=+2e1"});
  CHECK(expanded.source.text() == "0.1 0.1 steel 21\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:1:2: warning: 'mu' stays 0.1, as it is given on the command line [aprepro-override]\n");
}

TEST_CASE("a variable from the command line that the deck does not use is an error", "[parser][aprepro]") {
  CHECK(messages(expand("{{friction = 1}}\n", {}, {"fricton=2"}).diagnostics) ==
        "error: the deck does not use 'fricton' of -D; did you mean 'friction'?\n");
  CHECK(messages(expand("no braces, no friction\n", {}, {"friction=2"}).diagnostics) ==
        "error: the deck does not use 'friction' of -D\n");
  CHECK(messages(expand("{frictions = 1}\n", {}, {"friction=2"}).diagnostics).starts_with("error: "));
}

TEST_CASE("a variable from the command line that only another branch uses is warned about",
          "[parser][aprepro]") {
  CHECK(messages(expand("{if(0)}\n{friction}\n{endif}\n", {}, {"friction=2"}).diagnostics) ==
        "warning: the deck does not use 'friction' of -D [aprepro-unused]\n");
}

TEST_CASE("undefined and unused variables are warnings where the user is lenient", "[parser][aprepro]") {
  Diagnostics found;
  const std::vector<std::string> overrides{"bogus=1"};
  ApreproOptions options;
  options.overrides = overrides;
  options.is_lenient = true;
  CHECK(run_aprepro(make_source("a.i", "{a}\n"), options, found).text() == "0\n");
  CHECK(messages(found) ==
        "a.i:1:2: warning: 'a' is not defined, 0 is taken [aprepro-undefined]\n"
        "warning: the deck does not use 'bogus' of -D [aprepro-unused]\n");
}

TEST_CASE("definitions on the command line have a name and a value", "[parser][aprepro]") {
  CHECK(messages(expand("no braces\n", {}, {"=3", "x", "1a=2"}).diagnostics) ==
        "error: -D =3 is not of the form name=value\nerror: -D x is not of the form name=value\n"
        "error: -D 1a=2 is not of the form name=value\n");
}

TEST_CASE("copied text keeps its place and a value has that of its brace", "[parser][aprepro]") {
  const Expanded expanded = expand("ab {10*10} cd\n");
  REQUIRE(expanded.source.text() == "ab 100 cd\n");
  CHECK(expanded.source.locate(1).column == 2);
  CHECK(expanded.source.locate(3).column == 4);
  CHECK(expanded.source.locate(5).column == 4);
  CHECK(expanded.source.locate(7).column == 12);
}

TEST_CASE("includes and loop passes appear in the trail", "[parser][aprepro]") {
  const Expanded expanded = expand("\n{loop(3, i)}\n{include(b.i)}\n{endloop}\n", {{"b.i", "\nx {i}\n"}});
  REQUIRE(expanded.source.text() == "\n\nx 0\n\nx 1\n\nx 2\n");
  for (const std::size_t offset : {7, 9}) {
    const DeckLocation place = expanded.source.locate(offset);
    CHECK(place.file->name == "b.i");
    CHECK(place.line == 2);
    REQUIRE(place.trail);
    CHECK(place.trail->text == "included from a.i:3");
    REQUIRE(place.trail->outer);
    CHECK(place.trail->outer->text == "pass 2 of 3 of the loop at a.i:2:1");
    CHECK_FALSE(place.trail->outer->outer);
  }
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
  CHECK(problems("a {x").starts_with("a.i:1:3: error: nothing closes this brace; write \\{"));
}

TEST_CASE("control lines that do not fit together are reported at both places", "[parser][aprepro]") {
  CHECK(problems("{if(1)}\na\n") == "a.i:1:1: error: this {if(...)} has no {endif}\n");
  CHECK(problems("{endif}\n{else}\n{endloop}\n{case(1)}\n{endswitch}\n{default}\n") ==
        "a.i:1:1: error: {endif} without {if(...)}\n"
        "a.i:2:1: error: {else} without {if(...)}\n"
        "a.i:3:1: error: {endloop} without {loop(...)}\n"
        "a.i:4:1: error: {case(1)} without {switch(...)}\n"
        "a.i:5:1: error: {endswitch} without {switch(...)}\n"
        "a.i:6:1: error: {default} without {switch(...)}\n");
  CHECK(problems("{if(1)}\n{loop(2)}\na\n{endif}\n") ==
        "a.i:2:1: error: this {loop(...)} has no {endloop}; it is missing before {endif} at a.i:4:1\n");
  CHECK(problems("{if(1)}\n{else}\n{elseif(1)}\n{endif}\n") ==
        "a.i:3:1: error: this stands behind {else}, which must be last; the if begins at a.i:1:1\n");
  CHECK(problems("{endiff}\n") == "a.i:1:2: error: 'endiff' is not defined; did you mean 'endif'?\n");
}

TEST_CASE("without an included file the rest of the deck is not judged", "[parser][aprepro]") {
  CHECK(problems("{include(\"sizes.i\")}\nx = {width}\n{include(\"none.i\")}\n") ==
        "a.i:1:10: error: cannot include 'sizes.i': there is no such file\n"
        "a.i:3:10: error: cannot include 'none.i': there is no such file\n");
}

TEST_CASE("an included file that stands beside the file that names it is pointed at", "[parser][aprepro]") {
  const Files files{{"decks/parts.i", "{include(\"sizes.i\")}\n"}, {"decks/sizes.i", "{width = 2}\n"}};
  CHECK(problems("{include(\"decks/parts.i\")}\n", files) ==
        "decks/parts.i:1:10: error: cannot include 'sizes.i': there is no such file; paths count from the "
        "folder "
        "in which contactsim runs, and 'decks/sizes.i' is there\n"
        "  included from a.i:1\n");
}

TEST_CASE("loops and includes that cannot be carried out are reported", "[parser][aprepro]") {
  CHECK(
      problems("{loop(3+5)}\n{endloop}\n") ==
      "a.i:1:7: error: the count of a loop is a number or the name of a variable; give the expression a name "
      "first\n");
  CHECK(problems("{loop(2, 3)}\n{endloop}\n") == "a.i:1:9: error: '3' is not a name for a variable\n");
  CHECK(problems("{loop(2, i, \"a\")}\n{endloop}\n") ==
        "a.i:1:12: error: a loop takes numbers, found a string\n");
  CHECK(problems("{loop(1, i, 1, 1, 1)}\n{endloop}\n") ==
        "a.i:1:18: error: a loop takes a count, a name, a first value and a step\n");
  CHECK(problems("{include(\"none.i\")}\n") ==
        "a.i:1:10: error: cannot include 'none.i': there is no such file\n");
  CHECK(problems("{include(\"\" // \"\")}\n") ==
        "a.i:1:10: error: cannot include '': there is no file name\n");
  CHECK(problems("{include(./a.i)}\n") ==
        "a.i:1:10: error: cannot include './a.i': the file includes itself\n");
  CHECK(problems("{include(b)}\n", {{"b", "{include(c)}"}, {"c", "{include(b)}"}}) ==
        "c:1:10: error: cannot include 'b': the file includes itself\n"
        "  included from b:1\n  included from a.i:1\n");
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
