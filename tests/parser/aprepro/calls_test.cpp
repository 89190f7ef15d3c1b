// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/calls.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Values = std::vector<ApreproValue>;

/// The value of a call at offset 9 as a text, strings in quotes; or "offset: error; hint".
std::string called(const ApreproFunction& function, const Values& values) {
  ApreproState state;
  const ExpressionItem name{
      .kind = ExpressionItem::Kind::call, .offset = 9, .text = std::string(function.name)};
  try {
    const ApreproValue value = call_aprepro_function(function, name, values, state);
    if (const double* number = std::get_if<double>(&value)) return state.variables.print(*number);
    return '"' + std::get<std::string>(value) + '"';
  } catch (const ExpressionError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.text +
           (error.hint.empty() ? "" : "; " + error.hint);
  }
}

const ApreproFunction difference{
    "less", "x, y", "nn", "",
    ApreproFunction::OfNumbers([](std::span<const double> a) { return a[0] - a[1]; })};
const ApreproFunction repeat{"repeat", "s, n", "sn", "",
                             ApreproFunction::General([](ApreproFunction::Arguments a, ApreproState&) {
                               const auto n = static_cast<std::size_t>(std::get<double>(a[1]));
                               return ApreproValue(std::string(n, std::get<std::string>(a[0])[0]));
                             })};

}  // namespace

TEST_CASE("a function is called with the values of its arguments in their order", "[parser][aprepro]") {
  CHECK(called(difference, {5.0, 2.0}) == "3");
  CHECK(called(repeat, {std::string("ab"), 3.0}) == "\"aaa\"");
}

TEST_CASE("a call with a wrong number or type of arguments is refused at its name", "[parser][aprepro]") {
  CHECK(called(difference, {1.0}) == "9+4: 'less(x, y)' takes 2 arguments, found 1");
  CHECK(called(difference, {}) == "9+4: 'less(x, y)' takes 2 arguments, found 0");
  CHECK(called(repeat, {1.0, 2.0}) == "9+6: argument 1 of 'repeat(s, n)' must be a string, found a number");
  CHECK(called(repeat, {std::string("a"), std::string("b")}) ==
        "9+6: argument 2 of 'repeat(s, n)' must be a number, found a string");
}

TEST_CASE("a function that Aprepro has and contactsim has not says why", "[parser][aprepro]") {
  CHECK(called({"execute", "s", "s", "it would run programs", {}}, {}) ==
        "9+7: Aprepro's 'execute' is not supported: it would run programs");
}

TEST_CASE("a value that is not finite, or a text without end, is refused", "[parser][aprepro]") {
  CHECK(called(difference, {1e308, -1e308}) == "9+4: 'less' has no finite value here");
  const auto longest = static_cast<double>(max_aprepro_string);
  CHECK(called(repeat, {std::string("a"), longest}).size() == max_aprepro_string + 2);
  CHECK(called(repeat, {std::string("a"), longest + 1.0}) ==
        "9+6: 'repeat' gives a string of more than 1 MiB");
}

TEST_CASE("what a function itself refuses stands at its name", "[parser][aprepro]") {
  const ApreproFunction stops{
      "stops", "", "", "",
      ApreproFunction::General([](ApreproFunction::Arguments, ApreproState&) -> ApreproValue {
        throw ExpressionError{1, 1, "not today", "wait"};
      })};
  CHECK(called(stops, {}) == "9+5: not today; wait");
}
