// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "parser/aprepro/functions.hpp"

namespace contactsim {

namespace {

struct Operator {
  std::string_view symbol;
  ApreproLevel level;
};

constexpr Operator operators[] = {
    {"?", ApreproLevel::ternary},   {"||", ApreproLevel::logical_or}, {"&&", ApreproLevel::logical_and},
    {"==", ApreproLevel::relation}, {"!=", ApreproLevel::relation},   {"<", ApreproLevel::relation},
    {">", ApreproLevel::relation},  {"<=", ApreproLevel::relation},   {">=", ApreproLevel::relation},
    {"+", ApreproLevel::sum},       {"-", ApreproLevel::sum},         {"*", ApreproLevel::product},
    {"/", ApreproLevel::product},   {"%", ApreproLevel::product},     {"~", ApreproLevel::product},
    {"^", ApreproLevel::power},     {"**", ApreproLevel::power},      {"//", ApreproLevel::concatenation},
};

double truth(bool value) { return value ? 1.0 : 0.0; }

double divisor_of(double divisor, const ApreproToken& at) {
  if (divisor == 0.0) fail_at(at, "division by zero");
  return divisor;
}

double calculate(double a, double b, const ApreproToken& at) {
  if (at.text == "+" || at.text == "+=") return a + b;
  if (at.text == "-" || at.text == "-=") return a - b;
  if (at.text == "*" || at.text == "*=" || at.text == "~") return a * b;
  if (at.text == "%") return std::fmod(std::trunc(a), divisor_of(std::trunc(b), at));
  if (at.text == "/" || at.text == "/=") return a / divisor_of(b, at);
  return std::pow(a, b);
}

template <class T>
bool compare(const T& a, const T& b, std::string_view symbol) {
  if (symbol == "==") return a == b;
  if (symbol == "!=") return a != b;
  if (symbol == "<") return a < b;
  if (symbol == ">") return a > b;
  return symbol == "<=" ? a <= b : a >= b;
}

double compare_values(const ApreproValue& a, const ApreproToken& at, const ApreproValue& b) {
  if (a.index() != b.index()) fail_at(at, fmt::format("'{}' compares a number with a string", at.text));
  if (const double* number = std::get_if<double>(&a))
    return truth(compare(*number, std::get<double>(b), at.text));
  return truth(compare(std::get<std::string>(a), std::get<std::string>(b), at.text));
}

ApreproValue concatenate(const ApreproValue& a, const ApreproToken& at, const ApreproValue& b) {
  const std::string* left = std::get_if<std::string>(&a);
  const std::string* right = std::get_if<std::string>(&b);
  if (!left || !right) fail_at(at, "'//' joins strings, found a number", "make a number text by tostring()");
  if (left->size() + right->size() > max_aprepro_string) fail_at(at, "the string grows past 1 MiB");
  return *left + *right;
}

}  // namespace

std::optional<ApreproLevel> find_aprepro_level(std::string_view symbol) {
  const auto found = std::find_if(std::begin(operators), std::end(operators),
                                  [&](const Operator& o) { return o.symbol == symbol; });
  return found == std::end(operators) ? std::nullopt : std::optional(found->level);
}

void fail_at(const ApreproToken& at, std::string text, std::string hint) {
  const int length = at.kind == ApreproTokenKind::end ? 1 : static_cast<int>(at.text.size());
  throw ApreproError{at.offset, length, std::move(text), std::move(hint)};
}

bool is_true(const ApreproValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? *number != 0.0 : !std::get<std::string>(value).empty();
}

double number_of(const ApreproValue& value, const ApreproToken& at) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  fail_at(at, fmt::format("'{}' takes numbers, found a string", at.text),
          at.text == "+" ? "'//' joins strings" : "");
}

ApreproValue combine(const ApreproValue& a, const ApreproToken& at, const ApreproValue& b) {
  const auto level = find_aprepro_level(at.text);
  if (level == ApreproLevel::concatenation) return concatenate(a, at, b);
  if (level == ApreproLevel::logical_and) return truth(is_true(a) && is_true(b));
  if (level == ApreproLevel::logical_or) return truth(is_true(a) || is_true(b));
  if (level == ApreproLevel::relation) return compare_values(a, at, b);
  const double value = calculate(number_of(a, at), number_of(b, at), at);
  if (!std::isfinite(value)) fail_at(at, fmt::format("'{}' has no finite value here", at.text));
  return value;
}

}  // namespace contactsim
