// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/run.hpp"

#include "support/expanded_deck.hpp"

using namespace contactsim;

TEST_CASE("a loop repeats its lines and counts in a variable", "[parser][aprepro]") {
  CHECK(expanded_text("{loop(3)}\n{__loop_1}\n{endloop}\n") == "0\n1\n2\n");
  CHECK(expanded_text("{loop(2, i)}\n{i}\n{endloop}\n") == "0\n1\n");
  CHECK(expanded_text("{{n = 3}}{loop(n, i, 5, -2)} dropped\n  {i}\n  {endloop} dropped\n{i}\n") ==
        "  5\n  3\n  1\n1\n");
  CHECK(expanded_text("{loop(2, i, max(1, 2))}\n{i}\n{endloop}\n") == "2\n3\n");
}

TEST_CASE("loops nest, each with a variable of its own", "[parser][aprepro]") {
  CHECK(expanded_text("{loop(2)}\n{loop(2)}\n{__loop_1}{__loop_2}\n{endloop}\n{endloop}\n") ==
        "00\n01\n10\n11\n");
}

TEST_CASE("a loop of no passes leaves nothing", "[parser][aprepro]") {
  CHECK(expanded_text("a\n{loop(0)}\n{x = 1/0}\n{endloop}\n{loop(-1)}\nb\n{endloop}\nc\n") == "a\nc\n");
}

TEST_CASE("an include puts a file in its place", "[parser][aprepro]") {
  const Files files = {{"b.i", "b {x}\n"}, {"c.i", "c {x = 2}"}, {"d e.i", "d\n"}};
  CHECK(expanded_text("{{x = 1}}{include(\"b.i\")}\na\n", files) == "b 1\na\n");
  CHECK(expanded_text("{include(c.i)}\n{include(b.i)}\n\nz\n", files) == "c 2\nb 2\nz\n");
  CHECK(expanded_text("{{f = \"d \" // \"e.i\"}}{include(f)}\n{include(\"d \" // 'e.i')}\n", files) ==
        "d\nd\n");
  CHECK(expanded_text("v = {include(c.i)} end\n", files) == "v = c 2 end\n");
  CHECK(expanded_text("{cinclude(none.i)}\n{cinclude(\"d e.i\")}\n", files) == "d\n");
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

TEST_CASE("without an included file the rest of the deck is not judged", "[parser][aprepro]") {
  CHECK(expansion_problems("{include(\"sizes.i\")}\nx = {width}\n{include(\"none.i\")}\n") ==
        "a.i:1:10: error: cannot include 'sizes.i': there is no such file\n"
        "a.i:3:10: error: cannot include 'none.i': there is no such file\n");
}

TEST_CASE("an included file that stands beside the file that names it is pointed at", "[parser][aprepro]") {
  const Files files{{"decks/parts.i", "{include(\"sizes.i\")}\n"}, {"decks/sizes.i", "{width = 2}\n"}};
  CHECK(expansion_problems("{include(\"decks/parts.i\")}\n", files) ==
        "decks/parts.i:1:10: error: cannot include 'sizes.i': there is no such file; paths count from the "
        "folder "
        "in which contactsim runs, and 'decks/sizes.i' is there\n"
        "  included from a.i:1\n");
}

TEST_CASE("loops and includes that cannot be carried out are reported", "[parser][aprepro]") {
  CHECK(
      expansion_problems("{loop(3+5)}\n{endloop}\n") ==
      "a.i:1:7: error: the count of a loop is a number or the name of a variable; give the expression a name "
      "first\n");
  CHECK(expansion_problems("{loop(2, 3)}\n{endloop}\n") ==
        "a.i:1:9: error: '3' is not a name for a variable\n");
  CHECK(expansion_problems("{loop(2, i, \"a\")}\n{endloop}\n") ==
        "a.i:1:12: error: a loop takes numbers, found a string\n");
  CHECK(expansion_problems("{loop(1, i, 1, 1, 1)}\n{endloop}\n") ==
        "a.i:1:18: error: a loop takes a count, a name, a first value and a step\n");
  CHECK(expansion_problems("{include(\"none.i\")}\n") ==
        "a.i:1:10: error: cannot include 'none.i': there is no such file\n");
  CHECK(expansion_problems("{include(\"\" // \"\")}\n") ==
        "a.i:1:10: error: cannot include '': there is no file name\n");
  CHECK(expansion_problems("{include(./a.i)}\n") ==
        "a.i:1:10: error: cannot include './a.i': the file includes itself\n");
  CHECK(expansion_problems("{include(b)}\n", {{"b", "{include(c)}"}, {"c", "{include(b)}"}}) ==
        "c:1:10: error: cannot include 'b': the file includes itself\n"
        "  included from b:1\n  included from a.i:1\n");
}

TEST_CASE("arguments of a loop are cut at commas outside parentheses and strings", "[parser][aprepro]") {
  CHECK(expanded_text("{loop(2, i, strtod(\"4,5\"), min(1, (2)))}\n{i}\n{endloop}\n") == "4\n5\n");
  CHECK(expanded_text("{loop( 1 ,\ti )}\n{i}\n{endloop}\n") == "0\n");
  CHECK(expanded_text("{loop(2.9)}\nx\n{endloop}\n") == "x\nx\n");
  CHECK(expansion_problems("{loop()}\n{endloop}\n") ==
        "a.i:1:7: error: expected a value, found the end of the expression\n");
  CHECK(expansion_problems("{loop(2,)}\n{endloop}\n") == "a.i:1:9: error: '' is not a name for a variable\n");
}

TEST_CASE("a loop does not change what is immutable, and runs all the same", "[parser][aprepro]") {
  const Expanded expanded = expand("{loop(2, n)}\n{n}\n{endloop}\n", {}, {"n=7"});
  CHECK(expanded.source.text() == "7\n7\n");
  CHECK(messages(expanded.diagnostics) == "a.i:1:1: error: the loop cannot change 'n', which is immutable\n");
}

TEST_CASE("a line goes on behind an include only where the included text has no end of its own",
          "[parser][aprepro]") {
  const Files files = {{"ended.i", "x\n"}, {"open.i", "x"}, {"empty.i", ""}};
  CHECK(expanded_text("{include(ended.i)}\ny\n", files) == "x\ny\n");
  CHECK(expanded_text("{include(open.i)}\ny\n", files) == "x\ny\n");
  CHECK(expanded_text("a\n{include(empty.i)}\ny\n", files) == "a\ny\n");
  CHECK(expanded_text("{include(open.i)} y\n", files) == "x y\n");
}

TEST_CASE("an include of a number, or by a name that holds none, is reported", "[parser][aprepro]") {
  CHECK(expansion_problems("{include(\"a\" < \"b\")}\n") ==
        "a.i:1:10: error: an include takes a file name, found a number\n");
  CHECK(expanded_text("{{f = 3}}{include(f)}\n", {{"f", "the file f\n"}}) == "the file f\n");
  CHECK(expanded_text("{cinclude(f)}\nx\n") == "x\n");
  CHECK(expansion_problems("{cinclude(a.i)}\n") ==
        "a.i:1:11: error: cannot include 'a.i': the file includes itself\n");
}
