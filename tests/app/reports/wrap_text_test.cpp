// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/wrap_text.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("lines are broken at blanks, and a long word stays whole", "[app][table]") {
  CHECK(wrap_text("") == "");
  CHECK(wrap_text("short\n\n  lines") == "short\n\n  lines");
  const std::string path(150, 'p'), half(70, 'h');
  CHECK(wrap_text("  writes " + path + ", b\n") == "  writes " + path + ",\n      b\n");
  CHECK(wrap_text(half + " " + half + "\nend\n") == half + "\n      " + half + "\nend\n");
  const std::string umlauts = "\u00e4\u00f6\u00fc";
  CHECK(n_columns(umlauts) == 3);
  CHECK(wrap_text(umlauts + std::string(117, 'x')) == umlauts + std::string(117, 'x'));
}

TEST_CASE("a line of just the width of a page is not broken, one more is", "[app][table]") {
  const std::string left(60, 'l'), right(59, 'r');
  CHECK(wrap_text(left + " " + right) == left + " " + right);
  CHECK(wrap_text(left + " " + right + "r") == left + "\n      " + right + "r");
}

TEST_CASE("what is left of a broken line is indented, and may be broken again", "[app][table]") {
  std::string words, wrapped;
  for (int i = 0; i < 60; ++i) words += (i == 0 ? "" : " ") + std::string("word");
  // 24 words and their blanks are 119 columns, behind an indent of 4 there is room for 23 of them.
  for (int i = 0; i < 60; ++i)
    wrapped += (i == 0 ? "" : i == 24 || i == 47 ? "\n    " : " ") + std::string("word");
  CHECK(wrap_text(words, 4) == wrapped);
}

TEST_CASE("blanks at a break go away, others stay", "[app][table]") {
  const std::string half(70, 'h');
  CHECK(wrap_text(half + "    " + half + "  ") == half + "\n      " + half + "  ");
  CHECK(wrap_text("\n\n") == "\n\n");
  CHECK(wrap_text(std::string(130, ' ') + "\n") == std::string(130, ' ') + "\n");
}

TEST_CASE("a line is not broken early for a long word that follows it", "[app][table]") {
  // The last blank that leaves half of the line before it, else the first one behind.
  CHECK(wrap_text("a " + std::string(130, 'p') + " b") == "a " + std::string(130, 'p') + "\n      b");
}

TEST_CASE("columns are characters, not bytes, and none is cut", "[app][table]") {
  CHECK(n_columns("") == 0);
  CHECK(n_columns("a\u20acb\U0001f600") == 4);
  std::string euros;
  for (int i = 0; i < 59; ++i) euros += "\u20ac";
  CHECK(wrap_text(euros + " " + euros) == euros + " " + euros);
  CHECK(wrap_text(euros + " " + euros + "\u20ac\u20ac") == euros + "\n      " + euros + "\u20ac\u20ac");
}
