// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/catch.hpp"
#include "support/compiled_expression.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr double lost = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("operators of expressions bind as in C", "[core][expression]") {
  CHECK(value_of("1 + 2*3") == 7.0);
  CHECK(value_of("(1 + 2)*3") == 9.0);
  CHECK(value_of("24/4/3") == 2.0);
  CHECK(value_of("10 - 4 - 3") == 3.0);
  CHECK(value_of("2*3^2") == 18.0);
  CHECK(value_of("2^-1") == 0.5);
  CHECK(value_of("9.5 % 4") == 1.5);
  CHECK(value_of("-9 % 4") == -1.0);
  CHECK(value_of("1--7") == 8.0);
  CHECK(value_of("1---7") == -6.0);
  CHECK(value_of("-x^2", 3.0) == -9.0);
  CHECK(value_of("(-3)^2") == 9.0);
  CHECK(value_of("x*-x", 2.0) == -4.0);
  CHECK(value_of("+x", 2.0) == 2.0);
  CHECK(value_of("1 + 1 < 3") == 1.0);
  CHECK(value_of("!0 + 1") == 2.0);
  CHECK(value_of("!(x > 1)", 2.0) == 0.0);
}

TEST_CASE("comparisons and logic give 1 or 0, and anything but 0 is true", "[core][expression]") {
  CHECK(value_of("2 == 2") == 1.0);
  CHECK(value_of("2 != 2") == 0.0);
  CHECK(value_of("1 < 1") == 0.0);
  CHECK(value_of("1 <= 1") == 1.0);
  CHECK(value_of("2 > 1") == 1.0);
  CHECK(value_of("1 >= 2") == 0.0);
  CHECK(value_of("1 && -0.5") == 1.0);
  CHECK(value_of("1 && 0") == 0.0);
  CHECK(value_of("0 || 0") == 0.0);
  CHECK(value_of("0 || 1e-300") == 1.0);
  CHECK(value_of("1 || 0 && 0") == 1.0);
  CHECK(value_of("x > 1 && x < 2", 1.5) == 1.0);
  CHECK(value_of("x > 1 && x < 2", 2.5) == 0.0);
}

TEST_CASE("a ?: takes one side, the rightmost one belonging to the last ?", "[core][expression]") {
  const std::string ramp = "x < 1 ? 10 : x < 2 ? 20 : 30";
  CHECK(value_of(ramp, 0.0) == 10.0);
  CHECK(value_of(ramp, 1.0) == 20.0);
  CHECK(value_of(ramp, 2.0) == 30.0);
  CHECK(value_of("1 ? 0 ? 1 : 2 : 3") == 2.0);
  CHECK(value_of("1 + (x ? 2 : 3) * 2", 0.0) == 7.0);
  CHECK(value_of("x > 0 ? log(x) : 0", -1.0) == 0.0);
}

TEST_CASE("statements name parts of an expression, and the last one is its value", "[core][expression]") {
  CHECK(value_of("a = 2; b = a*x; b + 1;", 3.0) == 7.0);
  CHECK(value_of("a = x > 1 ? 5 : 6", 2.0) == 5.0);
  CHECK(value_of(";;a = 1;; a = a + 1; a = 10*a; ;", 0.0) == 20.0);
  CHECK(value_of("x = x + 1; X*x", 2.0) == 9.0);
  CHECK(value_of("pi = 3; pi") == 3.0);
  CHECK(value_of("(x > 0) ? pow(x, 2) : 0; ", 3.0) == 9.0);
}

TEST_CASE("names of expressions may be written in any case", "[core][expression]") {
  CHECK(value_of("Sin(PI/2) + X", 1.0) == Approx(2.0));
  CHECK(value_of("TWO_PI") == 2.0 * std::numbers::pi);
  CHECK(value_of("e") == std::numbers::e);
  CHECK(value_of("TRUE - false") == 1.0);
  const std::vector<std::string> inputs{"e", "v_x"};
  const std::array<double, 2> values{5.0, 7.0};
  CHECK(compiled("E + v_X", inputs).evaluate(values) == 12.0);
}

TEST_CASE("numbers of expressions may be written as in C", "[core][expression]") {
  CHECK(value_of("1.") == 1.0);
  CHECK(value_of(".5") == 0.5);
  CHECK(value_of("1.5e-3") == 1.5e-3);
  CHECK(value_of("2E+2") == 200.0);
  CHECK(problem_of("1e999") == "0+5: the number 1e999 is out of range");
  CHECK(problem_of("1.0.2") == "3+2: expected an operator or the end of the expression, found '.2'");
}

TEST_CASE("an expression without a finite value gives NaN or infinity", "[core][expression]") {
  CHECK(std::isnan(value_of("0/0")));
  CHECK(value_of("1/x", 0.0) == std::numeric_limits<double>::infinity());
  CHECK(value_of("-exp(1000)") == -std::numeric_limits<double>::infinity());
  CHECK(std::isnan(value_of("sqrt(x)", -1.0)));
  CHECK(std::isnan(value_of("max(x, 1)", lost)));
  CHECK(std::isnan(value_of("min(1, x, 2)", lost)));
  CHECK(std::isnan(value_of("linear_ramp(x, 0, 1)", lost)));
  CHECK(std::isnan(value_of("sign(x)", lost)));
}

TEST_CASE("what is wrong with an expression is told at its character", "[core][expression]") {
  CHECK(problem_of("") == "0+1: the expression is empty");
  CHECK(problem_of(" ; ") == "3+1: the expression is empty");
  CHECK(problem_of("x*") == "2+1: expected a value, found the end of the expression");
  CHECK(problem_of("x + * 2") == "4+1: expected a value, found '*'");
  CHECK(problem_of("x 2") == "2+1: expected an operator or the end of the expression, found '2'");
  CHECK(problem_of("(x") == "2+1: expected ')' for this '(', found the end of the expression");
  CHECK(problem_of("x)") == "1+1: expected an operator or the end of the expression, found ')'");
  CHECK(problem_of("()") == "1+1: expected a value, found ')'");
  CHECK(problem_of("x ? 1") == "5+1: expected ':' for this '?', found the end of the expression");
  CHECK(problem_of("x : 1") == "2+1: expected an operator or the end of the expression, found ':'");
  CHECK(problem_of("2 = x") == "2+1: expected an operator or the end of the expression, found '='");
  CHECK(problem_of("x $ 2") == "2+1: unexpected '$' in an expression");
  CHECK(problem_of("x \x01 2") == "2+1: unexpected character 0x01 in an expression");
  CHECK(problem_of("\xc3\xa4") == "0+1: unexpected character 0xc3 in an expression");
  CHECK(problem_of("v[0]", {"v"}) ==
        "1+1: components in brackets are not supported; a vector variable v has the components v_x v_y v_z");
}

TEST_CASE("what Sierra and C read differently needs parentheses", "[core][expression]") {
  const std::string hint = " has two readings; say by parentheses what belongs together";
  CHECK(problem_of("-2^2") == "0+1: -2^..." + hint);
  CHECK(problem_of("x*-2^2") == "2+1: -2^..." + hint);
  CHECK(problem_of("x^2^3") == "3+1: a ^ b ^ c" + hint);
  CHECK(problem_of("x^-x^3") == "4+1: a ^ b ^ c" + hint);
  CHECK(problem_of("x && 1 || 0") == "7+2: a && b || c" + hint);
  CHECK(problem_of("0 < x < 1") == "6+1: comparisons do not form chains; write a < b && b < c");
  CHECK(value_of("x^(2^3)", 2.0) == 256.0);
  CHECK(value_of("(x && 1) || 0", 1.0) == 1.0);
  CHECK(value_of("(0 < x) == 1", 1.0) == 1.0);
}

TEST_CASE("nesting without end is refused", "[core][expression]") {
  CHECK(value_of(repeated("(", 150) + "x" + repeated(")", 150), 2.0) == 2.0);
  CHECK(value_of(repeated("-", 150) + "x", 2.0) == 2.0);
  CHECK(value_of(repeated("x < 0 ? 1 : ", 150) + "x", 2.0) == 2.0);
  CHECK(value_of(repeated("x + ", 100000) + "x", 1.0) == 100001.0);
  const std::string deep = ": the expression is nested more than 200 deep";
  for (const std::string open : {"(", "-", "!", "sin(", "2^-(", "x ? ", "x ? 1 : "}) {
    INFO(open);
    CHECK(problem_of(repeated(open, 100000) + "x").find(deep) != std::string::npos);
  }
}
