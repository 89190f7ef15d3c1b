// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/operators.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "parser/aprepro/functions.hpp"

namespace contactsim {

namespace {

using Level = ExpressionLevel;

double number_of(const ApreproValue& value, const ExpressionItem& op) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  fail_at(op, fmt::format("'{}' takes numbers, found a string", op.text),
          op.text == "+" ? "'//' joins strings" : "");
}

double apply(const ExpressionItem& op, double a, double b) { return op.op->body(std::array{a, b}); }

double compare(const ApreproValue& a, const ExpressionItem& op, const ApreproValue& b) {
  if (a.index() != b.index()) fail_at(op, fmt::format("'{}' compares a number with a string", op.text));
  if (const double* number = std::get_if<double>(&a)) return apply(op, *number, std::get<double>(b));
  return apply(op, std::get<std::string>(a).compare(std::get<std::string>(b)), 0.0);
}

ApreproValue concatenate(const ApreproValue& a, const ExpressionItem& op, const ApreproValue& b) {
  const std::string* left = std::get_if<std::string>(&a);
  const std::string* right = std::get_if<std::string>(&b);
  if (!left || !right) fail_at(op, "'//' joins strings, found a number", "make a number text by tostring()");
  if (left->size() + right->size() > max_aprepro_string) fail_at(op, "the string grows past 1 MiB");
  return *left + *right;
}

bool divides_by_zero(std::string_view symbol, double divisor) {
  if (symbol == "%") return std::trunc(divisor) == 0.0;
  return (symbol == "/" || symbol == "/=") && divisor == 0.0;
}

}  // namespace

bool is_true(const ApreproValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? *number != 0.0 : !std::get<std::string>(value).empty();
}

ApreproValue combine(const ExpressionItem& op, const ApreproValue& value) {
  if (op.text == "!") return is_true(value) ? 0.0 : 1.0;
  const double number = number_of(value, op);
  return op.op->body != nullptr ? op.op->body({&number, 1}) : number;
}

ApreproValue combine(const ApreproValue& a, const ExpressionItem& op, const ApreproValue& b) {
  const Level level = op.op->level;
  if (level == Level::concatenation) return concatenate(a, op, b);
  if (level == Level::logical_and || level == Level::logical_or) return apply(op, is_true(a), is_true(b));
  if (level == Level::relation) return compare(a, op, b);
  const double left = number_of(a, op), right = number_of(b, op);
  if (divides_by_zero(op.text, right)) fail_at(op, "division by zero");
  const double value = apply(op, left, right);
  if (!std::isfinite(value)) fail_at(op, fmt::format("'{}' has no finite value here", op.text));
  return value;
}

}  // namespace contactsim
