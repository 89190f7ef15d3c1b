// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "parser/text/expression_grammar.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr double lost = std::numeric_limits<double>::quiet_NaN();

Expression compile(const std::string& text, const std::vector<std::string>& inputs) {
  return compile_expression(read_deck_expression({}, text), inputs);
}

double value_of(const std::string& text, double x = lost) {
  const std::vector<std::string> inputs{"x"};
  return compile(text, inputs).evaluate({&x, 1});
}

/// "offset+length: text; hint" of what is wrong with the expression, "" when it compiles.
std::string problem_of(const std::string& text, const std::vector<std::string>& inputs = {"x"}) {
  try {
    compile(text, inputs);
    return "";
  } catch (const ExpressionError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.text +
           (error.hint.empty() ? "" : "; " + error.hint);
  }
}

std::string repeated(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

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
  CHECK(compile("E + v_X", inputs).evaluate(values) == 12.0);
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
  CHECK(compile("a = 2; a*pi", inputs).is_constant());
  CHECK_FALSE(compile("a = x; 2", inputs).is_constant());
}
