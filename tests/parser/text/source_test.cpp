// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/source.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a source without preprocessing maps every character to itself", "[parser][source]") {
  const Source source = make_source("a.i", "ab\n\ncd\n");
  CHECK(to_string(source.locate(0)) == "a.i:1:1");
  CHECK(to_string(source.locate(2)) == "a.i:1:3");
  CHECK(to_string(source.locate(3)) == "a.i:2:1");
  CHECK(to_string(source.locate(5)) == "a.i:3:2");
  CHECK(line_text(source.locate(5)) == "cd");
}

TEST_CASE("an offset past the end gives the place behind the last character", "[parser][source]") {
  const Source source = make_source("a.i", "ab");
  CHECK(to_string(source.locate(2)) == "a.i:1:3");
  CHECK(to_string(source.locate(99)) == "a.i:1:3");
}

TEST_CASE("an empty source has no locations", "[parser][source]") {
  CHECK_FALSE(make_source("a.i", "").locate(0).is_known());
}

TEST_CASE("a byte order mark is dropped and columns count from the text behind it", "[parser][source]") {
  const Source source = make_source("a.i",
                                    "\xEF\xBB\xBF"
                                    "begin");
  CHECK(source.text() == "begin");
  CHECK(to_string(source.locate(0)) == "a.i:1:1");
}

TEST_CASE("text made at one place points there with every character", "[parser][source]") {
  const Source deck = make_source("a.i", "x = {1/3}\n");
  Source expanded;
  expanded.append_part(deck, 0, 4, nullptr);
  expanded.append_made("0.333", deck.origin(4));
  expanded.append_part(deck, 9, 10, nullptr);
  REQUIRE(expanded.text() == "x = 0.333\n");
  CHECK(expanded.locate(3).column == 4);
  CHECK(expanded.locate(4).column == 5);
  CHECK(expanded.locate(8).column == 5);
  CHECK(expanded.locate(9).column == 10);
}

TEST_CASE("a part of a source keeps its origins under a new trail", "[parser][source]") {
  const Source deck = make_source("a.i", "one\ntwo\n");
  Source mixed;
  mixed.append_part(deck, 0, 4, nullptr);
  mixed.append_made("3", deck.origin(4));
  const auto trail = std::make_shared<const Trail>(Trail{"pass 2 of 2", nullptr});
  Source pass;
  pass.append_part(mixed, 2, 5, trail);
  REQUIRE(pass.text() == "e\n3");
  CHECK(to_string(pass.locate(0)) == "a.i:1:3");
  CHECK(to_string(pass.locate(2)) == "a.i:2:1");
  CHECK(pass.locate(0).trail == trail);
  CHECK(pass.locate(2).trail == trail);
}
