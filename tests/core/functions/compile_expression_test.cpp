// SPDX-License-Identifier: BSD-3-Clause
// What names and functions of an expression mean, and its program.
#include <array>
#include <numbers>

#include "core/functions/expression.hpp"
#include "support/catch.hpp"
#include "support/compiled_expression.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("unknown names of an expression bring the nearest known one", "[core][expression]") {
  CHECK(problem_of("1 + sqr(x)") == "4+3: unknown function 'sqr'; did you mean 'sqrt'?");
  CHECK(problem_of("2*tiem", {"time"}) == "2+4: unknown name 'tiem' in the expression; did you mean 'time'?");
  CHECK(problem_of("sin(t)") == "4+1: unknown name 't' in the expression; it may read x");
  CHECK(problem_of("a = b; b = 1; a") == "4+1: unknown name 'b' in the expression; it may read x");
  CHECK(problem_of("sin") == "0+3: unknown name 'sin' in the expression; it may read x");
}

TEST_CASE("calls with a wrong number of arguments are told", "[core][expression]") {
  CHECK(problem_of("sin()") == "0+3: 'sin(x)' takes 1 argument, found 0");
  CHECK(problem_of("pow(x)") == "0+3: 'pow(x, y)' takes 2 arguments, found 1");
  CHECK(problem_of("max(1,2,3,4,5)") == "0+3: 'max(x, y[, z][, w])' takes 4 arguments, found 5");
  CHECK(problem_of("sin(x") == "5+1: expected ')' for this '(', found the end of the expression");
}

TEST_CASE("functions that give other values on every run are refused", "[core][expression]") {
  for (const ExpressionFunction& row : expression_functions()) {
    if (row.body != nullptr) continue;
    INFO(row.name);
    const std::string length = std::to_string(row.name.size());
    CHECK(problem_of(std::string(row.name) + "()") == "0+" + length + ": the function '" +
                                                          std::string(row.name) + "' is not supported; " +
                                                          std::string(row.help));
  }
}

TEST_CASE("an expression never keeps more values than it may", "[core][expression]") {
  const std::string too_many = "the expression keeps too many values at a time";
  CHECK(value_of(repeated("max(1, 2, 3, ", 130) + "9" + repeated(")", 130)) == 9.0);
  CHECK(problem_of(repeated("max(1, 2, 3, ", 140) + "9" + repeated(")", 140)).find(too_many) !=
        std::string::npos);
  std::string names;
  for (int i = 0; i < 100; ++i) names += "a" + std::to_string(i) + " = " + std::to_string(i) + ";";
  CHECK(value_of(names + "a99 - a1") == 98.0);
  CHECK(problem_of(names + "b = 1; b").find("more than 100 names are assigned") != std::string::npos);
}

TEST_CASE("an expression that reads no input is constant", "[core][expression]") {
  const std::vector<std::string> inputs{"x"};
  CHECK(compiled("a = 2; a*pi", inputs).is_constant());
  CHECK_FALSE(compiled("a = x; 2", inputs).is_constant());
}

TEST_CASE("names that an expression sets hide its inputs from there on, inputs hide constants",
          "[core][expression]") {
  CHECK(value_of("a = x; x = 10*x; a + x", 2.0) == 22.0);
  CHECK(value_of("X = 3; x", 2.0) == 3.0);
  CHECK(value_of("pi", 2.0) == std::numbers::pi);
  const double pi = 4.0;
  CHECK(compiled("2*PI", {"pi"}).evaluate({&pi, 1}) == 8.0);
  CHECK(value_of("pi = 5; pi + e*0", 0.0) == 5.0);
}

TEST_CASE("a name that is set again keeps its place", "[core][expression]") {
  CHECK(value_of("a = 1; b = 2; a = a + b; b = a*10; a + b") == 33.0);
  std::string names;
  for (int i = 0; i < 300; ++i) names += "a = " + std::to_string(i) + ";";
  CHECK(value_of(names + "a") == 299.0);  // one name, and no value that stays
}

TEST_CASE("inputs are those of their positions", "[core][expression]") {
  const std::array<double, 3> values{5.0, 7.0, 11.0};
  CHECK(compiled("c - a", {"a", "b", "c"}).evaluate(values) == 6.0);
  CHECK(compiled("c - a", {"c", "b", "a"}).evaluate(values) == -6.0);
  CHECK(compiled("b", {"a", "b", "c"}).evaluate(values) == 7.0);
}

TEST_CASE("a ?: in either side of another keeps its own way out", "[core][expression]") {
  const std::string of_both = "x > 0 ? (x > 2 ? 1 : 2) : (x < -2 ? 3 : 4)";
  CHECK(value_of(of_both, 3.0) == 1.0);
  CHECK(value_of(of_both, 1.0) == 2.0);
  CHECK(value_of(of_both, -3.0) == 3.0);
  CHECK(value_of(of_both, -1.0) == 4.0);
  CHECK(value_of("10 + (x ? 1 : 2)*3", 1.0) == 13.0);
  CHECK(value_of("10 + (x ? 1 : 2)*3", 0.0) == 16.0);
  CHECK(value_of("max(x ? 1 : 2, x ? 3 : 4)", 0.0) == 4.0);
}

TEST_CASE("a mistake that was found when the text was read is told when it is compiled",
          "[core][expression]") {
  const DeckExpression read = read_deck_expression({}, "1 +");
  REQUIRE(read.error);
  CHECK_THROWS_AS(compile_expression(read, {}), ExpressionError);
}
