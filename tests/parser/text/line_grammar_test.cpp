// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/line_grammar.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using LineKind = ParsedLine::Kind;

/// The words of the first line of a text: bare ones as they are, <symbols>, quoted ones with their quotes.
std::string spans_of(const std::string& text, LineKind kind = LineKind::command) {
  const Source source = make_source("a.i", text);
  Diagnostics said;
  LineReader reader(source, said);
  LogicalLine line;
  REQUIRE(reader.next(line));
  ParsedLine parsed;
  parsed.words.resize(3);  // memory of an earlier line
  parse_line(line, parsed);
  CHECK(parsed.kind == kind);
  std::string all;
  for (const ParsedLine::Span& span : parsed.words) {
    const std::string word = line.text.substr(span.begin, span.end - span.begin);
    if (!all.empty()) all += ' ';
    all += span.kind == WordKind::symbol ? "<" + word + ">" : word;
    if (span.kind == WordKind::quoted) CHECK(word.front() == word.back());
  }
  return all;
}

}  // namespace

TEST_CASE("a line is words, symbols and quoted texts", "[parser][lines]") {
  CHECK(spans_of("a b\tc,d , e") == "a b c d e");
  CHECK(spans_of("a=1") == "a <=> 1");
  CHECK(spans_of("a<=b>=c==d<e>f") == "a <<=> b <>=> c <==> d <<> e <>> f");
  CHECK(spans_of("a===b") == "a <==> <=> b");
  CHECK(spans_of("x = \"b = c\"'d'") == "x <=> \"b = c\" 'd'");
  CHECK(spans_of("-1.5e+3 %B.e @x") == "-1.5e+3 %B.e @x");
}

TEST_CASE("a group in parentheses belongs to the word before it, a broken one is no group",
          "[parser][lines]") {
  CHECK(spans_of("stress(xx, 1) a") == "stress(xx, 1) a");
  CHECK(spans_of("f(a = 1)(b, c)d e") == "f(a = 1)(b, c)d e");
  CHECK(spans_of("f(a, b") == "f(a b");
  CHECK(spans_of("f((a, b), c)") == "f((a, b) c)");
  CHECK(spans_of("(a, b)") == "(a b)");  // no word stands before it
}

TEST_CASE("a colon that ends a word is dropped, others are part of it", "[parser][lines]") {
  CHECK(spans_of("variable: v") == "variable v");
  CHECK(spans_of("variable:=v") == "variable <=> v");
  CHECK(spans_of("a:b c::") == "a:b c:");
  CHECK(spans_of(": a") == "a");
}

TEST_CASE("BEGIN and END are words of their own at the start of a line alone", "[parser][lines]") {
  CHECK(spans_of("begin block a", LineKind::begin) == "block a");
  CHECK(spans_of(" , BeGiN", LineKind::begin) == "");
  CHECK(spans_of("EnD block", LineKind::end) == "block");
  CHECK(spans_of("End: block") == "End block");  // a colon does not follow it
  CHECK(spans_of("end", LineKind::end) == "");
  CHECK(spans_of("begin=x", LineKind::begin) == "<=> x");
  CHECK(spans_of("beginning end") == "beginning end");
  CHECK(spans_of("ending") == "ending");
  CHECK(spans_of("begin_block") == "begin_block");
  CHECK(spans_of("'begin' a") == "'begin' a");
}

TEST_CASE("the keyword of a line has its place", "[parser][lines]") {
  const Source source = make_source("a.i", "  end x");
  Diagnostics said;
  LineReader reader(source, said);
  LogicalLine line;
  REQUIRE(reader.next(line));
  ParsedLine parsed;
  parse_line(line, parsed);
  CHECK(line.text.substr(parsed.keyword, 3) == "end");
}
