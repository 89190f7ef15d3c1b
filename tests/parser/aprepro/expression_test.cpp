// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/expression.hpp"

#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

struct Session {
  ApreproState state;
  std::vector<std::string> warnings;

  Session() {
    state.warn = [this](std::string_view id, const ExpressionError& problem) {
      warnings.push_back(std::string(id) + ": " + problem.text);
    };
  }

  /// The value as {expr} prints it, or "offset: error; hint".
  std::string print(std::string_view expression) {
    try {
      const ApreproValue value = evaluate_aprepro(expression, 0, state);
      const double* number = std::get_if<double>(&value);
      return number != nullptr ? state.variables.print(*number) : '"' + std::get<std::string>(value) + '"';
    } catch (const ExpressionError& error) {
      return std::to_string(error.offset) + ": " + error.text + (error.hint.empty() ? "" : "; " + error.hint);
    }
  }
};

std::string print(std::string_view expression) {
  Session session;
  const std::string printed = session.print(expression);
  CHECK(session.warnings.empty());
  return printed;
}

}  // namespace

TEST_CASE("numbers print with ten digits", "[parser][aprepro]") {
  const auto [expression, printed] = GENERATE(table<std::string, std::string>({
      {"1", "1"},
      {"1.", "1"},
      {".5", "0.5"},
      {"10e-1", "1"},
      {"10.E-1", "1"},
      {"1/3", "0.3333333333"},
      {"1e10", "1e+10"},
      {"1234567890", "1234567890"},
      {"12345678901", "1.23456789e+10"},
      {"1e-5", "1e-05"},
      {"PI", "3.141592654"},
      {"-0.0", "-0"},
  }));
  CHECK(print(expression) == printed);
}

TEST_CASE("operators bind as in the table", "[parser][aprepro]") {
  const auto [expression, printed] = GENERATE(table<std::string, std::string>({
      {"2 + 3 * 4", "14"},
      {"(2 + 3) * 4", "20"},
      {"2 - 3 - 4", "-5"},
      {"24 / 4 / 2", "3"},
      {"2 * 3 ~ 4", "24"},
      {"7 % 4 * 2", "6"},
      {"-7.9 % 4", "-3"},
      {"2 ^ 3 ^ 2", "512"},
      {"2 ** 3 ** 2", "512"},
      {"-2 ^ 2", "-4"},
      {"2 ^ -1", "0.5"},
      {"2 * -3", "-6"},
      {"--3", "2"},
      {"++3", "4"},
      {"+3", "3"},
      {"!0", "1"},
      {"!2 + 1", "1"},
      {"1 < 2", "1"},
      {"1 > 2", "0"},
      {"2 <= 2", "1"},
      {"2 >= 3", "0"},
      {"1 + 1 == 2", "1"},
      {"1 != 1", "0"},
      {"0 && 0 || 1", "1"},
      {"1 || 0 && 0", "1"},
      {"1 < 2 && 2 < 3", "1"},
      {"1 ? 2 : 3", "2"},
      {"0 ? 2 : 0 ? 3 : 4", "4"},
      {"1 > 0 ? \"a\" : \"b\"", "\"a\""},
      {"[5.9]", "5"},
      {"[-5.9] + 1", "-4"},
      {"\"a\" // \"b\" == 'ab'", "1"},
      {"\"a\" < \"b\"", "1"},
      {"\"a\" // \"b\" // 'c'", "\"abc\""},
      {"\"v\" // tostring(1 + 1)", "\"v2\""},
      {"2\n+\t2\r\n", "4"},
  }));
  INFO(expression);
  CHECK(print(expression) == printed);
}

TEST_CASE("assignments give their value and chain from the right", "[parser][aprepro]") {
  Session session;
  const std::vector<std::pair<std::string, std::string>> steps = {
      {"a = b = 3", "3"},
      {"a += 2", "5"},
      {"a -= 1", "4"},
      {"a *= b", "12"},
      {"a /= 4", "3"},
      {"a ^= 2", "9"},
      {"a **= 2", "81"},
      {"a++", "81"},
      {"a", "82"},
      {"++a", "83"},
      {"a--", "83"},
      {"--a", "81"},
      {"1 + a = 2", "3"},
      {"a", "2"},
      {"a = \"text\"", "\"text\""},
      {"a == \"text\"", "1"},
      {"a = 1 > 0 ? 5 : 6", "5"},
      {"x:1 = 4", "4"},
      {"_y2 = x:1", "4"},
  };
  for (const auto& [expression, printed] : steps) {
    INFO(expression);
    CHECK(session.print(expression) == printed);
  }
  CHECK(session.warnings.empty());
}

TEST_CASE("both sides of logical operators and of ?: are evaluated", "[parser][aprepro]") {
  Session session;
  session.print("a = 0");
  session.print("0 && (a += 1)");
  session.print("1 || (a += 1)");
  session.print("1 ? 2 : (a += 1)");
  CHECK(session.print("a") == "3");
}

TEST_CASE("an undefined name is 0 with a warning, names being case-sensitive", "[parser][aprepro]") {
  Session session;
  session.print("radius = 2");
  CHECK(session.print("2 * Radius") == "0");
  CHECK(session.print("n++") == "0");
  CHECK(session.print("n") == "1");
  CHECK(session.warnings == std::vector<std::string>{"aprepro-undefined: 'Radius' is not defined",
                                                     "aprepro-undefined: 'n' is not defined"});
}

TEST_CASE("immutable variables keep their value", "[parser][aprepro]") {
  Session session;
  session.state.makes_immutable = true;
  CHECK(session.print("a = 1") == "1");
  CHECK(session.print("_b = 1") == "1");
  session.state.makes_immutable = false;
  CHECK(session.print("a = 2") == "1");
  CHECK(session.print("a++") == "1");
  CHECK(session.print("_b = 2") == "2");
  CHECK(session.warnings ==
        std::vector<std::string>(2, "aprepro-immutable: 'a' stays 1, as it is immutable"));
}

TEST_CASE("mistakes in expressions are named at their place", "[parser][aprepro]") {
  const auto [expression, message] = GENERATE(table<std::string, std::string>({
      {"1 +", "3: expected a value, found the end of the expression"},
      {"1 + )", "4: expected a value, found ')'"},
      {"(1 + 2", "6: expected ')' for this '(', found the end of the expression"},
      {"[1", "2: expected ']' for this '[', found the end of the expression"},
      {"1 2", "2: expected an operator or '}', found '2'; one expression per pair of braces"},
      {"sqr(2)", "0: unknown function 'sqr'; did you mean 'sqrt'?"},
      {"endlop(2)", "0: unknown function 'endlop'; did you mean 'endloop'?"},
      {"sqrt(1, 2)", "0: 'sqrt(x)' takes 1 arguments, found 2"},
      {"sqrt(\"a\")", "0: argument 1 of 'sqrt(x)' must be a number, found a string"},
      {"1 + sqrt(-1)", "4: 'sqrt' has no finite value here"},
      {"1e200 * 1e200", "6: '*' has no finite value here"},
      {"1e999", "0: the number 1e999 is out of range"},
      {"1 / 0", "2: division by zero"},
      {"1 % 0.5", "2: division by zero"},
      {"\"a\" + 1", "4: '+' takes numbers, found a string; '//' joins strings"},
      {"\"a\" // 1", "4: '//' joins strings, found a number; make a number text by tostring()"},
      {"\"a\" == 1", "4: '==' compares a number with a string"},
      {"1 ? 2 : \"a\"", "2: '?' chooses between a number and a string"},
      {"\"abc", "0: the string \" is never closed; only a string in '...' may span lines"},
      {"1 # 2", "2: unexpected '#' in an expression"},
      {"1 \x01", "2: unexpected character 0x01 in an expression"},
      {"a[1]", "0: arrays are not supported"},
      {"++(1)", "2: expected a name for '++' or '--', found '('"},
      {"csv_array(\"f\")", "0: Aprepro's 'csv_array' is not supported: arrays are not supported"},
      {"execute(\"1\")", "0: Aprepro's 'execute' is not supported: text made by the deck is not run as deck"},
      {"error(\"stop here\")", "0: stop here"},
      {"format(1, \"%s\")", "0: '%s' is not a format for one number, such as \"%.4e\""},
  }));
  INFO(expression);
  CHECK(print(expression) == message);
}

TEST_CASE("a colon that a name has swallowed is explained", "[parser][aprepro]") {
  Session session;
  CHECK(session.print("1 ? a:b") ==
        "7: expected ':' for this '?', found the end of the expression; a name may hold ':', so put a blank "
        "before "
        "it");
}

TEST_CASE("expressions nested too deep are refused", "[parser][aprepro]") {
  const std::string unit = GENERATE("(", "- ", "!", "a=", "[", "1?", "abs(", "1?1:", "2^");
  std::string expression;
  for (int i = 0; i < 100000; ++i) expression += unit;
  Session session;
  CHECK(session.print(expression).find("nested more than 200 deep") != std::string::npos);
}

TEST_CASE("a string that grows without end is refused", "[parser][aprepro]") {
  Session session;
  session.print("a = \"0123456789abcdef\"");
  std::string last;
  for (int i = 0; i < 20; ++i) last = session.print("a = a // a");
  CHECK(last == "6: the string grows past 1 MiB");
}

TEST_CASE("the output format follows _FORMAT where it is safe", "[parser][aprepro]") {
  CHECK(format_number("%.3f", 2.0 / 3.0) == "0.667");
  CHECK(format_number("t%08.3E_", 1.0) == "t1.000E+00_");
  CHECK(format_number("%+g", 1.0) == "+1");
  for (const char* unsafe :
       {"", "no", "%d", "%s", "%n", "%lg", "%g%g", "%%", "%100g", "%.100f", "%*g", "%"}) {
    CHECK_FALSE(format_number(unsafe, 1.0).has_value());
  }
  Session session;
  session.print("_FORMAT = \"%.2f\"");
  CHECK(session.print("1/3") == "0.33");
  session.print("_FORMAT = \"%s\"");
  CHECK(session.print("1/3") == "0.3333333333");
}
