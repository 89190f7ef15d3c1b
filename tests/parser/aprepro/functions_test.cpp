// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/functions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "parser/aprepro/calls.hpp"
#include "parser/aprepro/expression.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

ApreproValue value_of(std::string_view expression) {
  ApreproState state;
  state.warn = [](std::string_view, const ExpressionError& problem) { FAIL(problem.text); };
  state.read_file = [](const std::string& path) -> TextFile {
    if (path == "there") return {"two\nlines\n"};
    return {"", "there is no such file", TextFile::Failure::missing};
  };
  return evaluate_aprepro(expression, 0, state);
}

double number(std::string_view expression) { return std::get<double>(value_of(expression)); }
std::string text(std::string_view expression) { return std::get<std::string>(value_of(expression)); }

}  // namespace

TEST_CASE("every function is documented, sorted, and callable with the arguments it names",
          "[parser][aprepro]") {
  const auto rows = aprepro_functions();
  CHECK(
      std::is_sorted(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
  for (const ApreproFunction& row : rows) {
    INFO(row.name);
    CHECK(find_aprepro_function(row.name) == &row);
    CHECK_FALSE(row.help.empty());
    const auto n_commas = std::count(row.parameters.begin(), row.parameters.end(), ',');
    CHECK(row.types.size() == (row.parameters.empty() ? 0 : static_cast<std::size_t>(n_commas) + 1));
    std::vector<ApreproValue> arguments;
    for (const char type : row.types)
      arguments.push_back(type == 'n' ? ApreproValue(1.0) : ApreproValue("%g"));
    const bool is_refused = std::holds_alternative<std::monostate>(row.call);
    const bool stops = row.name == "error" || row.name == "atanh" || row.name == "file_to_string";
    ApreproState state;
    const ExpressionItem name{.kind = ExpressionItem::Kind::call, .offset = 7, .text = std::string(row.name)};
    try {
      call_aprepro_function(row, name, arguments, state);
      CHECK_FALSE((is_refused || stops));
    } catch (const ExpressionError& error) {
      CHECK((is_refused || stops));
      CHECK(error.offset == 7);
    }
  }
}

TEST_CASE("mathematical functions have the values of the textbook", "[parser][aprepro]") {
  const auto [expression, value] = GENERATE(table<std::string, double>({
      {"abs(-2)", 2.0},
      {"acos(0.5)", M_PI / 3.0},
      {"acosd(0.5)", 60.0},
      {"acosh(cosh(2))", 2.0},
      {"asin(0.5)", M_PI / 6.0},
      {"asind(0.5)", 30.0},
      {"asinh(sinh(2))", 2.0},
      {"atan(1)", M_PI / 4.0},
      {"atan2(1, -1)", 0.75 * M_PI},
      {"atan2d(1, -1)", 135.0},
      {"atand(1)", 45.0},
      {"atanh(tanh(0.5))", 0.5},
      {"cbrt(-8)", -2.0},
      {"ceil(1.2)", 2.0},
      {"cos(PI)", -1.0},
      {"cosd(60)", 0.5},
      {"d2r(180)", M_PI},
      {"dim(5, 3)", 2.0},
      {"dim(3, 5)", 0.0},
      {"dist(0, 0, 3, 4)", 5.0},
      {"erf(0) + erfc(0)", 1.0},
      {"exp(1)", M_E},
      {"expm1(1)", M_E - 1.0},
      {"floor(-1.2)", -2.0},
      {"fmod(7.5, 2)", 1.5},
      {"hypot(3, 4)", 5.0},
      {"int(-5.9)", -5.0},
      {"lgamma(5)", std::log(24.0)},
      {"ln(E)", 1.0},
      {"log(E)", 1.0},
      {"log10(1000)", 3.0},
      {"log1p(E - 1)", 1.0},
      {"max(1, 2)", 2.0},
      {"min(1, 2)", 1.0},
      {"nint(2.5)", 3.0},
      {"nint(-2.5)", -3.0},
      {"polarX(2, 60)", 1.0},
      {"polarY(2, 30)", 1.0},
      {"pow(2, 3)", 8.0},
      {"r2d(PI)", 180.0},
      {"sign(3, -1)", -3.0},
      {"sign(-3, 0)", 3.0},
      {"sin(PI / 2)", 1.0},
      {"sind(30)", 0.5},
      {"sinh(0)", 0.0},
      {"sqrt(9)", 3.0},
      {"tan(PI / 4)", 1.0},
      {"tand(45)", 1.0},
      {"tanh(0)", 0.0},
      {"tgamma(5)", 24.0},
      {"Vangle(1, 0, 0, 2)", M_PI / 2.0},
      {"Vangled(1, 0; 1, 1)", 45.0},
      {"Vangle(2, 0, 3, 0)", 0.0},
  }));
  INFO(expression);
  CHECK(number(expression) == Approx(value).margin(1e-14).epsilon(1e-14));  // a few roundings
}

TEST_CASE("constants have their values", "[parser][aprepro]") {
  CHECK(number("PI_2 * 2 - PI") == 0.0);
  CHECK(number("TAU") == Approx(2.0 * M_PI));
  CHECK(number("SQRT2 ^ 2") == Approx(2.0));
  CHECK(number("DEG * RAD") == Approx(1.0));
  CHECK(number("90 * RAD") == Approx(M_PI / 2.0));
  CHECK(number("E") == Approx(M_E));
  CHECK(number("GAMMA") == Approx(0.5772156649));
  CHECK(number("PHI ^ 2 - PHI") == Approx(1.0));
  CHECK(number("TRUE + FALSE") == 1.0);
}

TEST_CASE("functions of text work on copies", "[parser][aprepro]") {
  CHECK(text("tolower(\"aBc1\")") == "abc1");
  CHECK(text("to_upper('aBc1')") == "ABC1");
  CHECK(text("tostring(0)") == "0");
  CHECK(text("tostring(1/4)") == "0.25");
  CHECK(text("IO(-2.7)") == "-2");
  CHECK(text("format(PI, \"%.2f\")") == "3.14");
  CHECK(text("get_word(2, \" one two, three\", \" ,\")") == "two");
  CHECK(text("get_word(4, \" one two, three\", \" ,\")").empty());
  CHECK(text("get_word(-1, \"one\", \" \")").empty());
  CHECK(number("word_count(\" one two, three\", \" ,\")") == 3.0);
  CHECK(text("extract(\"a [b] c\", \"[\", \"]\")") == "[b");
  CHECK(text("extract(\"a [b] c\", \"\", \" [\")") == "a");
  CHECK(text("extract(\"a [b] c\", \"x\", \"\")").empty());
  CHECK(text("extract(\"a [b] c\", \"b\", \"\")") == "b] c");
  CHECK(number("strtod(\" +2.5e1 mm\")") == 25.0);
  CHECK(number("strtod(\"mm\")") == 0.0);
  CHECK(text("file_to_string(\"there\")") == "two\nlines\n");
  CHECK(text("getenv(\"CONTACTSIM_SURELY_UNSET\")").empty());
}

TEST_CASE("random numbers are the same on every run and follow the seed", "[parser][aprepro]") {
  const double first = number("rand(2, 4)");
  CHECK(first >= 2.0);
  CHECK(first < 4.0);
  CHECK(first == number("rand(2, 4)"));
  CHECK(number("0 * srand(7) + rand(0, 1)") != number("0 * srand(8) + rand(0, 1)"));
  CHECK(number("0 * srand(7) + rand(0, 1)") == number("0 * srand(7) + rand(0, 1)"));
}
