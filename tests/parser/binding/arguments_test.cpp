// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/arguments.hpp"

#include <functional>

#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

/// What reading the words after the first of a line says, "" when it goes well. The first word is the
/// command.
std::string said(const std::string& line, const std::function<void(Arguments&)>& read_line) {
  const Command command = command_of(line);
  Diagnostics diagnostics;
  try {
    Arguments arguments("size", std::span(command.words).subspan(1), command, command.words[0].location);
    read_line(arguments);
    arguments.expect_end();
  } catch (const ArgumentError& error) {
    diagnostics.add(error.diagnostic);
  }
  return messages(diagnostics);
}

double real_of(const std::string& text) {
  double value = 0.0;
  REQUIRE(said("size " + text, [&](Arguments& a) { value = a.real(); }) == "");
  return value;
}

void read_real(Arguments& arguments) { arguments.real(); }

}  // namespace

TEST_CASE("numbers are read in every spelling of decks", "[parser][arguments]") {
  CHECK(real_of("1") == 1.0);
  CHECK(real_of("1.") == 1.0);
  CHECK(real_of(".9") == 0.9);
  CHECK(real_of("-50") == -50.0);
  CHECK(real_of("+2") == 2.0);
  CHECK(real_of("1e-4") == 1e-4);
  CHECK(real_of("1.0E+06") == 1e6);
  CHECK(real_of("4.176e9") == 4.176e9);
  CHECK(real_of("1.0d0") == 1.0);
  CHECK(real_of("2.5D-3") == 2.5e-3);
}

TEST_CASE("what is no finite number is refused", "[parser][arguments]") {
  for (const std::string text : {"nan", "inf", "1e999", "0x10", "1.2.3", "--1", "+-1", "1e", "12h"}) {
    INFO(text);
    CHECK(said("size = " + text, read_real) ==
          "a.i:1:8: error: expected a number for 'size', found '" + text + "'\n");
  }
}

TEST_CASE("a line that ends too early is reported at its command", "[parser][arguments]") {
  CHECK(said("size =", read_real) ==
        "a.i:1:1: error: expected a number after 'size', found the end of the line\n");
  CHECK(said("size", [](Arguments& a) { a.names(); }) ==
        "a.i:1:1: error: expected a name after 'size', found the end of the line\n");
}

TEST_CASE("one separator may stand before the value", "[parser][arguments]") {
  for (const std::string separator : {"", "= ", "is ", "ARE ", "="}) {
    INFO(separator);
    CHECK(said("size " + separator + "3", read_real) == "");
  }
  CHECK(said("size = = 3", read_real) == "a.i:1:8: error: expected a number for 'size', found '='\n");
}

TEST_CASE("numbers keep to their range", "[parser][arguments]") {
  CHECK(said("size = 0", [](Arguments& a) { a.positive(); }) ==
        "a.i:1:8: error: 'size' must be greater than 0, found '0'\n");
  CHECK(said("size = -1e-9", [](Arguments& a) { a.non_negative(); }) ==
        "a.i:1:8: error: 'size' must not be negative, found '-1e-9'\n");
  CHECK(said("size = 0", [](Arguments& a) { a.positive_integer(); }) ==
        "a.i:1:8: error: 'size' must be at least 1, found '0'\n");
  CHECK(said("size = 2.5", [](Arguments& a) { a.integer(); }) ==
        "a.i:1:8: error: expected an integer for 'size', found '2.5'\n");
  CHECK(said("size = 99999999999999999999", [](Arguments& a) { a.integer(); }) ==
        "a.i:1:8: error: expected an integer for 'size', found '99999999999999999999'\n");
}

TEST_CASE("switches take on, true, yes and their opposites", "[parser][arguments]") {
  for (const std::string word : {"ON", "true", "Yes"}) {
    bool value = false;
    CHECK(said("size = " + word, [&](Arguments& a) { value = a.on_off(); }) == "");
    CHECK(value);
  }
  for (const std::string word : {"off", "FALSE", "no"}) {
    bool value = true;
    CHECK(said("size = " + word, [&](Arguments& a) { value = a.on_off(); }) == "");
    CHECK_FALSE(value);
  }
  CHECK(said("size = onn", [](Arguments& a) { a.on_off(); }) ==
        "a.i:1:8: error: expected one of on, true, yes, off, false, no for 'size', found 'onn'; did you mean "
        "'on'?\n");
}

TEST_CASE("a choice may hold several words, and the longest counts", "[parser][arguments]") {
  const std::vector<std::string> choices{"piecewise", "piecewise linear", "constant"};
  std::size_t chosen = 9;
  CHECK(said("size = PIECEWISE_LINEAR", [&](Arguments& a) { chosen = a.choice(choices); }) == "");
  CHECK(chosen == 1);
  CHECK(said("size = piecewise", [&](Arguments& a) { chosen = a.choice(choices); }) == "");
  CHECK(chosen == 0);
  CHECK(said("size = constnat", [&](Arguments& a) { a.choice(choices); }) ==
        "a.i:1:8: error: expected one of piecewise, piecewise linear, constant for 'size', found 'constnat'; "
        "did "
        "you mean 'constant'?\n");
}

TEST_CASE("lists take the remaining words", "[parser][arguments]") {
  std::vector<double> values;
  CHECK(said("size = 1, 2 3", [&](Arguments& a) { values = a.reals(); }) == "");
  CHECK(values == std::vector<double>{1.0, 2.0, 3.0});
  CHECK(said("size = 1, two", [&](Arguments& a) { a.reals(); }) ==
        "a.i:1:11: error: expected a number for 'size', found 'two'\n");
  std::vector<DeckName> names;
  CHECK(said("size = a \"b c\"", [&](Arguments& a) { names = a.names(); }) == "");
  REQUIRE(names.size() == 2);
  CHECK(names[1].text == "b c");
  CHECK(names[1].location.column == 10);
}

TEST_CASE("a name is no symbol", "[parser][arguments]") {
  CHECK(said("size = < 3", [](Arguments& a) { a.name(); }) ==
        "a.i:1:8: error: expected a name after 'size', found '<'\n");
}

TEST_CASE("the rest of a line is taken as it is written", "[parser][arguments]") {
  std::string rest, all;
  CHECK(said("size = Big, - very  big ", [&](Arguments& a) { rest = a.rest(); }) == "");
  CHECK(rest == "Big, - very  big");
  CHECK(said("size is it big", [&](Arguments& a) { all = a.all(); }) == "");
  CHECK(all == "is it big");
}

TEST_CASE("a fixed word that is missing is reported with what stands there", "[parser][arguments]") {
  CHECK(said("size 3 annd 4", [](Arguments& a) {
          a.real();
          a.expect("and");
        }) == "a.i:1:8: error: expected 'and' in 'size', found 'annd'; did you mean 'and'?\n");
}

TEST_CASE("a word too many is an error", "[parser][arguments]") {
  CHECK(said("size = 3 4", read_real) == "a.i:1:10: error: 'size' takes no more words, found '4'\n");
}
