// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/deck_location.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

DeckLocation location(const std::string& text, int line, int column) {
  return {std::make_shared<SourceFile>(SourceFile{"plate.i", text}), line, column, nullptr};
}

}  // namespace

TEST_CASE("a location of the deck is its file, line and column", "[core][deck_location]") {
  CHECK(to_string(location("", 12, 25)) == "plate.i:12:25");
  CHECK(to_string(DeckLocation{}).empty());
}

TEST_CASE("the line of a location stands without its line end", "[core][deck_location]") {
  const std::string text = "begin a\r\n\n  b = 1\nend";
  CHECK(line_text(location(text, 1, 1)) == "begin a");
  CHECK(line_text(location(text, 2, 1)).empty());
  CHECK(line_text(location(text, 3, 3)) == "  b = 1");
  CHECK(line_text(location(text, 4, 1)) == "end");
}

TEST_CASE("a line behind the last one, or of no file, has no text", "[core][deck_location]") {
  CHECK(line_text(location("one\n", 2, 1)).empty());
  CHECK(line_text(location("one\ntwo", 3, 1)).empty());
  CHECK(line_text(location("", 1, 1)).empty());
  CHECK(line_text(DeckLocation{}).empty());
}
