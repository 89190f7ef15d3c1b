// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/wrap_text.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a text that fits stays on one line", "[core][text]") {
  CHECK(wrap_text("", 0, 4) == "\n");
  CHECK(wrap_text("a few words", 80, 4) == "a few words\n");
  CHECK(wrap_text(std::string(100, 'x'), 0, 4) == std::string(100, 'x') + "\n");
}

TEST_CASE("a line ends before the word that would pass column 100", "[core][text]") {
  const std::string word(40, 'x');
  CHECK(wrap_text(word + " " + word + " " + word, 0, 2) == word + " " + word + "\n  " + word + "\n");
  // 60 + 40 is the last column, and one more is too much.
  CHECK(wrap_text(word, 60, 2) == word + "\n");
  CHECK(wrap_text("ab " + word, 57, 2) == "ab " + word + "\n");
  CHECK(wrap_text("ab " + word, 58, 2) == "ab\n  " + word + "\n");
}

TEST_CASE("choices break behind a bar, which stays on its line", "[core][text]") {
  const std::string word(60, 'x');
  CHECK(wrap_text(word + "|" + word + "|y", 0, 3) == word + "|\n   " + word + "|y\n");
}

TEST_CASE("a word that is longer than a line has one for itself", "[core][text]") {
  const std::string word(120, 'x');
  CHECK(wrap_text("a " + word + " b", 0, 1) == "a\n " + word + "\n b\n");
}
