// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_operators.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contactsim {

namespace {

using Numbers = std::span<const double>;
using Level = ExpressionLevel;
using enum ExpressionDialects;

double sum(Numbers a) { return a[0] + a[1]; }
double difference(Numbers a) { return a[0] - a[1]; }
double product(Numbers a) { return a[0] * a[1]; }
double quotient(Numbers a) { return a[0] / a[1]; }
double power(Numbers a) { return std::pow(a[0], a[1]); }
double truth(bool value) { return value ? 1.0 : 0.0; }

constexpr ExpressionOperator operators[] = {
    {"=", Level::definition, function},
    {"=", Level::assignment, aprepro},
    {"+=", Level::assignment, aprepro, sum},
    {"-=", Level::assignment, aprepro, difference},
    {"*=", Level::assignment, aprepro, product},
    {"/=", Level::assignment, aprepro, quotient},
    {"^=", Level::assignment, aprepro, power},
    {"**=", Level::assignment, aprepro, power},
    {"||", Level::logical_or, all, [](Numbers a) { return truth(a[0] != 0.0 || a[1] != 0.0); }},
    {"&&", Level::logical_and, all, [](Numbers a) { return truth(a[0] != 0.0 && a[1] != 0.0); }},
    {"==", Level::relation, all, [](Numbers a) { return truth(a[0] == a[1]); }},
    {"!=", Level::relation, all, [](Numbers a) { return truth(a[0] != a[1]); }},
    {"<", Level::relation, all, [](Numbers a) { return truth(a[0] < a[1]); }},
    {"<=", Level::relation, all, [](Numbers a) { return truth(a[0] <= a[1]); }},
    {">", Level::relation, all, [](Numbers a) { return truth(a[0] > a[1]); }},
    {">=", Level::relation, all, [](Numbers a) { return truth(a[0] >= a[1]); }},
    {"+", Level::sum, all, sum},
    {"-", Level::sum, all, difference},
    {"*", Level::product, all, product},
    {"~", Level::product, aprepro, product},
    {"/", Level::product, all, quotient},
    {"%", Level::product, function, [](Numbers a) { return std::fmod(a[0], a[1]); }},
    {"%", Level::product, aprepro, [](Numbers a) { return std::fmod(std::trunc(a[0]), std::trunc(a[1])); }},
    {"+", Level::prefix, all},
    {"-", Level::prefix, all, [](Numbers a) { return -a[0]; }},
    {"!", Level::prefix, all, [](Numbers a) { return truth(a[0] == 0.0); }},
    {"^", Level::power, all, power},
    {"**", Level::power, aprepro, power},
    {"//", Level::concatenation, aprepro},
    {"++", Level::step, aprepro, sum},
    {"--", Level::step, aprepro, difference},
    {"[", Level::bracket, aprepro, [](Numbers a) { return std::trunc(a[0]); }},
};

}  // namespace

std::span<const ExpressionOperator> expression_operators() { return operators; }

void fail_at(const ExpressionItem& item, std::string text, std::string hint) {
  const auto length = std::max<std::size_t>(1, item.text.size());
  throw ExpressionError{item.offset, static_cast<int>(length), std::move(text), std::move(hint)};
}

}  // namespace contactsim
