// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/operators.hpp"

#include <algorithm>
#include <functional>

#include "parser/aprepro/functions.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Level = ExpressionLevel;

/// An operator of Aprepro as an item at offset 5.
ExpressionItem operator_item(const std::string& symbol, bool is_prefix = false) {
  const auto rows = expression_operators();
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const ExpressionOperator& one) {
    return one.symbol == symbol && (one.level == Level::prefix) == is_prefix &&
           one.dialects != ExpressionDialects::function;
  });
  REQUIRE(row != rows.end());
  return {.kind = ExpressionItem::Kind::binary, .offset = 5, .op = &*row, .text = symbol};
}

ApreproValue of_two(const ApreproValue& a, const std::string& symbol, const ApreproValue& b) {
  return combine(a, operator_item(symbol), b);
}

double number_of_two(double a, const std::string& symbol, double b) {
  return std::get<double>(of_two(a, symbol, b));
}

/// "offset: error; hint" of what an operator refuses.
std::string refusal_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const ExpressionError& error) {
    return std::to_string(error.offset) + ": " + error.text + (error.hint.empty() ? "" : "; " + error.hint);
  }
  return "";
}

std::string refusal_of_two(const ApreproValue& a, const std::string& symbol, const ApreproValue& b) {
  return refusal_of([&] { of_two(a, symbol, b); });
}

const ApreproValue word_a = std::string("a"), word_b = std::string("b"), no_text = std::string();

}  // namespace

TEST_CASE("true is a number other than 0, or a string that is not empty", "[parser][aprepro]") {
  CHECK(is_true(1e-300));
  CHECK(is_true(-1.0));
  CHECK_FALSE(is_true(0.0));
  CHECK_FALSE(is_true(-0.0));
  CHECK(is_true(std::string("0")));
  CHECK_FALSE(is_true(no_text));
}

TEST_CASE("operators of numbers have their values", "[parser][aprepro]") {
  CHECK(number_of_two(2, "+", 3) == 5);
  CHECK(number_of_two(2, "-", 3) == -1);
  CHECK(number_of_two(2, "*", 3) == 6);
  CHECK(number_of_two(2, "~", 3) == 6);
  CHECK(number_of_two(3, "/", 2) == 1.5);
  CHECK(number_of_two(-7.9, "%", 3.9) == -1);  // both are cut to whole numbers first
  CHECK(number_of_two(2, "^", 10) == 1024);
  CHECK(number_of_two(2, "**", -1) == 0.5);
  CHECK(number_of_two(7, "/=", 2) == 3.5);
  CHECK(number_of_two(7, "^=", 2) == 49);
  CHECK(number_of_two(2, "&&", 0) == 0);
  CHECK(number_of_two(2, "||", 0) == 1);
}

TEST_CASE("relations compare numbers with numbers and strings with strings", "[parser][aprepro]") {
  CHECK(number_of_two(1, "<=", 1) == 1);
  CHECK(number_of_two(1, "!=", 1) == 0);
  for (const auto& [symbol, value] : std::vector<std::pair<std::string, double>>{
           {"<", 1}, {"<=", 1}, {">", 0}, {">=", 0}, {"==", 0}, {"!=", 1}}) {
    INFO(symbol);
    CHECK(std::get<double>(of_two(word_a, symbol, word_b)) == value);
  }
  CHECK(std::get<double>(of_two(std::string("ab"), ">", word_a)) == 1);
  CHECK(refusal_of_two(1.0, "<", word_a) == "5: '<' compares a number with a string");
}

TEST_CASE("logical operators take values of any type", "[parser][aprepro]") {
  CHECK(std::get<double>(of_two(word_a, "&&", 1.0)) == 1);
  CHECK(std::get<double>(of_two(no_text, "||", 0.0)) == 0);
  CHECK(std::get<double>(combine(operator_item("!", true), no_text)) == 1);
  CHECK(std::get<double>(combine(operator_item("!", true), 2.0)) == 0);
}

TEST_CASE("signs are of numbers", "[parser][aprepro]") {
  CHECK(std::get<double>(combine(operator_item("-", true), 2.0)) == -2);
  CHECK(std::get<double>(combine(operator_item("+", true), 2.0)) == 2);
  CHECK(refusal_of([] { combine(operator_item("-", true), word_a); }) ==
        "5: '-' takes numbers, found a string");
}

TEST_CASE("strings are joined by // and nothing else", "[parser][aprepro]") {
  CHECK(std::get<std::string>(of_two(word_a, "//", word_b)) == "ab");
  CHECK(std::get<std::string>(of_two(no_text, "//", no_text)).empty());
  CHECK(refusal_of_two(word_a, "+", word_b) == "5: '+' takes numbers, found a string; '//' joins strings");
  CHECK(refusal_of_two(word_a, "*", 2.0) == "5: '*' takes numbers, found a string");
  CHECK(refusal_of_two(word_a, "//", 2.0) ==
        "5: '//' joins strings, found a number; make a number text by tostring()");
  const std::string half(max_aprepro_string / 2, 'x');
  CHECK(std::get<std::string>(of_two(half, "//", half)).size() == max_aprepro_string);
  CHECK(refusal_of_two(half + "x", "//", half) == "5: the string grows past 1 MiB");
}

TEST_CASE("what has no finite value is refused at its operator", "[parser][aprepro]") {
  CHECK(refusal_of_two(1.0, "/", 0.0) == "5: division by zero");
  CHECK(refusal_of_two(0.0, "/=", -0.0) == "5: division by zero");
  CHECK(refusal_of_two(1.0, "%", 0.9) == "5: division by zero");
  CHECK(refusal_of_two(1e308, "*", 10.0) == "5: '*' has no finite value here");
  CHECK(refusal_of_two(-8.0, "^", 1.0 / 3.0) == "5: '^' has no finite value here");
  CHECK(refusal_of_two(0.0, "**", -1.0) == "5: '**' has no finite value here");
}
