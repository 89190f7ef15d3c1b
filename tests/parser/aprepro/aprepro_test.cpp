// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/aprepro.hpp"

#include "support/expanded_deck.hpp"

using namespace contactsim;

TEST_CASE("a deck without braces comes through untouched", "[parser][aprepro]") {
  const std::string deck = "begin a # it's \"so\" \\# \\\n\tx = 1\r\nend";
  CHECK(expanded_text(deck) == deck);
}

TEST_CASE("expressions are replaced by their values everywhere, comments and quotes too",
          "[parser][aprepro]") {
  CHECK(expanded_text("# {dt = 1e-6}\nx = {2*dt} \"{dt}\" '{\"s\"}'\n") ==
        "# 1e-06\nx = 2e-06 \"1e-06\" 's'\n");
}

TEST_CASE("double braces evaluate and print nothing, empty ones too", "[parser][aprepro]") {
  CHECK(expanded_text("a{{x = 2}}b{x}c{ }d{{}}e\n") == "ab2cde\n");
}

TEST_CASE("braces behind a backslash are literal", "[parser][aprepro]") {
  CHECK(expanded_text("\\{a\\} \\\\ {1}\n") == "{a} \\\\ 1\n");
  CHECK(expanded_text("only \\} here\n") == "only } here\n");
  CHECK(expanded_text("{1}}\n") == "1}\n");
}

TEST_CASE("an expression and a string in single quotes may span lines", "[parser][aprepro]") {
  CHECK(expanded_text("{ 1 +\n 2 }\n{s = 'two\nlines with }'}|\n") == "3\ntwo\nlines with }|\n");
}

TEST_CASE("text behind an if is joined to the next line, which is warned about", "[parser][aprepro]") {
  const Expanded expanded = expand("{if(1)} x\ny\n{elseif(1)} not taken\n{endif}\n");
  CHECK(expanded.source.text() == " xy\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:1:9: warning: this text is joined to the next line, as the line end behind {if(1)} is dropped; "
        "put it on "
        "a line of its own [aprepro-joined]\n");
}

TEST_CASE("control words with an argument may be capitalised", "[parser][aprepro]") {
  CHECK(expanded_text("{Ifdef(x)}\na\n{Else}\nb\n{EndIf}\n{Loop(2)}\nc\n{EndLoop}\n") == "b\nc\nc\n");
  CHECK(expanded_text("{{Default = 3}}{Default} {{IF = 4}}{IF}\n") == "3 4\n");
}

TEST_CASE("a comment mark with a blank behind it goes away before a control line", "[parser][aprepro]") {
  const Files files = {{"b.i", "live\n# dead\n"}};
  const std::string mark = GENERATE("#", "$", "//", "  #", "##");
  CHECK(expanded_text(mark + " {include(b.i)}\n", files) == "live\n# dead\n");
  CHECK(expanded_text(mark + " {if(1)}\na\n" + mark + " {else}\nb\n" + mark + "\t{endif}\nc\n") == "a\nc\n");
  CHECK(expanded_text(mark + " {loop(2)}\na\n" + mark + " {endloop}\nb\n") == "a\na\nb\n");
}

TEST_CASE("other marks and comments before a control line stay", "[parser][aprepro]") {
  CHECK(expanded_text("x # {if(1)}\n{endif}\n") == "x # ");
  CHECK(expanded_text("/ {if(1)}\n{endif}\n") == "/ ");
}

TEST_CASE("a comment mark glued to a control line hides the next line, which is warned about",
          "[parser][aprepro]") {
  const Expanded expanded = expand("#{if(1)}\nhidden\n#{endif}\nhidden too\n");
  CHECK(expanded.source.text() == "#hidden\n#hidden too\n");
  CHECK(messages(expanded.diagnostics) ==
        "a.i:1:1: warning: this comment mark comes to stand before the next line and hides it; put a blank "
        "between "
        "the mark and the brace [aprepro-hidden]\n  1 more like this, at a.i:3:1\n");
  CHECK(expanded_text("#{include(b.i)}\nx\n", {{"b.i", "# head\nlive\n"}}) == "## head\nlive\nx\n");
  CHECK(expansion_problems("#{include(b.i)}\n", {{"b.i", "live\n"}}) ==
        "a.i:1:1: warning: this comment mark hides the first line of 'b.i'; put a blank between the mark and "
        "the "
        "brace [aprepro-hidden]\n");
}

TEST_CASE("{#} at the start of a line comments it out", "[parser][aprepro]") {
  CHECK(expanded_text("{#} {include(\"none\")} {\n {#}{x\na {1}\n") ==
        "# {include(\"none\")} {\n #{x\na 1\n");
}

TEST_CASE("VERBATIM and APREPRO switch the expansion off", "[parser][aprepro]") {
  CHECK(expanded_text("{VERBATIM(ON)}{a} {if(1)}\n{VERBATIM(OFF)}{1}\n") == "{a} {if(1)}\n1\n");
  CHECK(expanded_text("{APREPRO(OFF)}{a} {VERBATIM(OFF)}{APREPRO(ON)}{1}\n") == "{a} {VERBATIM(OFF)}1\n");
  CHECK(expanded_text("{VERBATIM(ON)}{to the end") == "{to the end");
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

TEST_CASE("control lines that do not fit together are reported at both places", "[parser][aprepro]") {
  CHECK(expansion_problems("{if(1)}\na\n") == "a.i:1:1: error: this {if(...)} has no {endif}\n");
  CHECK(expansion_problems("{endif}\n{else}\n{endloop}\n{case(1)}\n{endswitch}\n{default}\n") ==
        "a.i:1:1: error: {endif} without {if(...)}\n"
        "a.i:2:1: error: {else} without {if(...)}\n"
        "a.i:3:1: error: {endloop} without {loop(...)}\n"
        "a.i:4:1: error: {case(1)} without {switch(...)}\n"
        "a.i:5:1: error: {endswitch} without {switch(...)}\n"
        "a.i:6:1: error: {default} without {switch(...)}\n");
  CHECK(expansion_problems("{if(1)}\n{loop(2)}\na\n{endif}\n") ==
        "a.i:2:1: error: this {loop(...)} has no {endloop}; it is missing before {endif} at a.i:4:1\n");
  CHECK(expansion_problems("{if(1)}\n{else}\n{elseif(1)}\n{endif}\n") ==
        "a.i:3:1: error: this stands behind {else}, which must be last; the if begins at a.i:1:1\n");
  CHECK(expansion_problems("{endiff}\n") ==
        "a.i:1:2: error: 'endiff' is not defined; did you mean 'endif'?\n");
}
