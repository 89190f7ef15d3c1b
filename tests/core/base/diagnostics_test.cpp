// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/diagnostics.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

DeckLocation at(int line, int column) {
  static const auto file =
      std::make_shared<const SourceFile>(SourceFile{"a.i", "first line\n\tsecond line\r\nthird\n"});
  return {file, line, column, nullptr};
}

}  // namespace

TEST_CASE("diagnostics are sorted by place and equal ones are grouped", "[core][diagnostics]") {
  Diagnostics found;
  found.add_error(at(3, 1), "unknown command 'third'");
  found.add_warning("deck-ignored", at(2, 2), "'second' has no effect here");
  found.add_error(at(1, 1), "unknown command 'third'");
  REQUIRE(found.error_count() == 2);
  const auto groups = found.grouped();
  REQUIRE(groups.size() == 2);
  CHECK(format_machine(groups[0]) ==
        "a.i:1:1: error: unknown command 'third'\n  1 more like this, at a.i:3:1\n");
  CHECK(format_machine(groups[1]) == "a.i:2:2: warning: 'second' has no effect here [deck-ignored]\n");
}

TEST_CASE("problems of one kind in a row are counted from the twenty-first on", "[core][diagnostics]") {
  Diagnostics found;
  for (int line = 1; line <= 50; ++line)
    found.add_error(at(line, 1), "unknown command '" + std::to_string(line) + " 1.5' in 'function f'");
  found.add_error(at(51, 1), "something else");
  for (int line = 52; line <= 80; ++line) found.add_warning("w", at(line, 1), "row " + std::to_string(line));
  const auto groups = found.grouped();
  REQUIRE(groups.size() == 20 + 1 + 20);
  CHECK(format_machine(groups[18]) == "a.i:19:1: error: unknown command '19 1.5' in 'function f'\n");
  CHECK(format_machine(groups[19]) ==
        "a.i:20:1: error: unknown command '20 1.5' in 'function f'\n"
        "  30 more of this kind, up to a.i:50:1\n");
  CHECK(format_machine(groups[20]) == "a.i:51:1: error: something else\n");
  CHECK(groups[40].n_alike == 9);
  CHECK(found.error_count() == 51);
}

TEST_CASE("a caret stands under the word, through tabs and without the line end", "[core][diagnostics]") {
  Diagnostics found;
  found.add_error(at(2, 9), "unknown word 'line'", "did you mean 'lines'?", 4);
  CHECK(format_with_caret(found.grouped().front(), false) ==
        "a.i:2:9: error: unknown word 'line'; did you mean 'lines'?\n"
        "    \tsecond line\n"
        "    \t       ^~~~\n");
}

TEST_CASE("a trail of includes and loops follows the message", "[core][diagnostics]") {
  const auto outer = std::make_shared<const Trail>(Trail{"loop 2 of 3 at top.i:4", nullptr});
  const auto inner = std::make_shared<const Trail>(Trail{"included from top.i:5", outer});
  DeckLocation place = at(1, 7);
  place.trail = inner;
  Diagnostics found;
  found.add_error(place, "wrong");
  CHECK(format_machine(found.grouped().front()) ==
        "a.i:1:7: error: wrong\n  included from top.i:5\n  loop 2 of 3 at top.i:4\n");
}

TEST_CASE("a diagnostic without a place comes last and has no prefix", "[core][diagnostics]") {
  Diagnostics found;
  found.add_error({}, "the mesh has no block");
  found.add_error(at(1, 1), "first");
  CHECK(format_machine(found.grouped().back()) == "error: the mesh has no block\n");
}

TEST_CASE("control characters that a message or a deck line quotes do not reach the terminal",
          "[core][diagnostics]") {
  const auto file = std::make_shared<const SourceFile>(SourceFile{"a.i", "bad\x1b[2J\tword\n"});
  Diagnostics found;
  found.add_error({file, 1, 9, nullptr}, "unknown word 'a\nb\x1b'", "a\tb", 0);
  CHECK(found.all().front().length == 1);
  CHECK(format_with_caret(found.grouped().front(), false) ==
        "a.i:1:9: error: unknown word 'a b '; a b\n    bad [2J\tword\n           \t^\n");
}
