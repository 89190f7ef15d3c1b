// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_place.hpp"

#include <memory>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// "line:column" of the character at `offset` of an expression that begins in the deck at line 1, `column`.
std::string place_of(const std::string& deck, int column, const std::string& expression, std::size_t offset) {
  const auto file = std::make_shared<const SourceFile>(SourceFile{"a.i", deck});
  const DeckLocation place = locate({{file, 1, column, nullptr}, expression}, offset);
  return std::to_string(place.line) + ":" + std::to_string(place.column);
}

}  // namespace

TEST_CASE("a character of an expression is found in the deck", "[core][expression]") {
  const std::string deck = "is \"x + y\"\nend\n";
  CHECK(place_of(deck, 4, "x + y", 0) == "1:5");
  CHECK(place_of(deck, 4, "x + y", 4) == "1:9");
  CHECK(place_of(deck, 4, "x + y", 5) == "1:10");  // the end of the expression
  CHECK(place_of("is x + y", 4, "x + y", 4) == "1:8");
  CHECK(place_of("is x + y", 4, "x + y", 5) == "1:9");
}

TEST_CASE("a character of an expression is found on a continued line", "[core][expression]") {
  const std::string deck = "\"x + \\# comment\n  y + \\$\r\nz\"";
  const std::string expression = "x +   y + z";
  CHECK(place_of(deck, 1, expression, 3) == "1:5");
  CHECK(place_of(deck, 1, expression, 4) == "2:1");
  CHECK(place_of(deck, 1, expression, 6) == "2:3");
  CHECK(place_of(deck, 1, expression, 10) == "3:1");
}

TEST_CASE("an expression that the deck does not hold as it is keeps its own place", "[core][expression]") {
  CHECK(place_of("\"{a} + y\"", 1, "2 + y", 4) == "1:1");
  CHECK(place_of("\"x + {a} * y\"", 1, "x + 2 * y", 2) == "1:4");
  CHECK(place_of("\"x + {a} * y\"", 1, "x + 2 * y", 8) == "1:1");
  CHECK(place_of("\"x\"", 1, "x", 7) == "1:1");
  CHECK(place_of("\"x \\#", 1, "x y", 2) == "2:1");
  CHECK(place_of("", 9, "x", 1) == "1:9");
  CHECK_FALSE(locate({{}, "x"}, 0).is_known());
}
