// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/text_words.hpp"

#include <filesystem>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// The words of a text, in a file "t.txt".
struct WordsOf {
  explicit WordsOf(const std::string& text)
      : words((write_bytes(directory.file("t.txt"), text), directory.file("t.txt"))) {}
  TemporaryDirectory directory;
  TextWords words;
};

std::string refusal_of_word(const std::string& word, bool is_real) {
  WordsOf text(word);
  try {
    is_real ? text.words.real() : static_cast<double>(text.words.integer());
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(what.find("line"));
  }
  return "";
}

}  // namespace

TEST_CASE("words of a text have their lines", "[io][import]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("t.txt"), "one  +2\n\n 3.5e-1 rest of it \nx");
  TextWords words(directory.file("t.txt"));
  CHECK(words.word() == "one");
  CHECK(words.integer() == 2);
  CHECK(words.real() == 0.35);
  CHECK(words.line_number() == 3);
  CHECK(words.rest_of_line() == "rest of it");
  CHECK_THROWS_WITH(words.integer(), Contains("t.txt: line 4: expected a whole number, found 'x'"));
  CHECK(words.is_at_end());
  CHECK_THROWS_AS(TextWords(directory.file("none")), FileError);
}

TEST_CASE("numbers are whole words, with a sign at most", "[io][import]") {
  CHECK(WordsOf("-17").words.integer() == -17);
  CHECK(WordsOf("9223372036854775807").words.integer() == 9223372036854775807);
  CHECK(WordsOf("+1.5E+3").words.real() == 1500.0);
  CHECK(WordsOf(".5").words.real() == 0.5);
  CHECK(WordsOf("3.").words.real() == 3.0);
  for (const char* word : {"9223372036854775808", "1.0", "1e3", "+-1", "++1", "+", "0x10", "1,"}) {
    CHECK(refusal_of_word(word, false) ==
          "line 1: expected a whole number, found '" + std::string(word) + "'");
  }
  for (const char* word : {"1.0D+3", "1e999", "+-1.5", "-", "1.5.", "one", "nan", "inf", "-infinity"}) {
    CHECK(refusal_of_word(word, true) == "line 1: expected a number, found '" + std::string(word) + "'");
  }
}

TEST_CASE("a word that is not there is reported with the line at which the file ends", "[io][import]") {
  WordsOf text("one\ntwo\n\n");
  text.words.word();
  CHECK(text.words.word() == "two");
  CHECK(text.words.line_number() == 2);
  CHECK_THROWS_WITH(text.words.word(),
                    Contains("t.txt: line 4: the file ends here, in the middle of something"));
  CHECK_THROWS_AS(WordsOf("").words.word(), FileError);
}

TEST_CASE("the rest of a line is without blanks around it, and ends with the line", "[io][import]") {
  WordsOf text("a b c \r\n\n d\n");
  CHECK(text.words.word() == "a");
  CHECK(text.words.rest_of_line() == "b c");
  CHECK(text.words.rest_of_line() == "");
  CHECK(text.words.line_number() == 1);
  CHECK_FALSE(text.words.is_at_end());
  CHECK(text.words.line_number() == 3);
  CHECK(text.words.rest_of_line() == "d");
  CHECK(text.words.is_at_end());
  CHECK(WordsOf("").words.rest_of_line() == "");
}

TEST_CASE("a folder, or what is not there, is no text", "[io][import]") {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory.file("folder"));
  CHECK_THROWS_WITH(TextWords(directory.file("folder")), directory.file("folder") + ": cannot be read");
  CHECK_THROWS_WITH(TextWords(directory.file("none")), directory.file("none") + ": cannot be read");
}
