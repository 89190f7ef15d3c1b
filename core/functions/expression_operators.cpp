// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_operators.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace contactsim {

namespace {

using Arguments = std::span<const double>;

constexpr auto operators = std::to_array<ExpressionOperator>({
    {"||", ExpressionLevel::logical_or, [](Arguments a) { return a[0] != 0.0 || a[1] != 0.0 ? 1.0 : 0.0; }},
    {"&&", ExpressionLevel::logical_and, [](Arguments a) { return a[0] != 0.0 && a[1] != 0.0 ? 1.0 : 0.0; }},
    {"==", ExpressionLevel::relation, [](Arguments a) { return a[0] == a[1] ? 1.0 : 0.0; }},
    {"!=", ExpressionLevel::relation, [](Arguments a) { return a[0] != a[1] ? 1.0 : 0.0; }},
    {"<", ExpressionLevel::relation, [](Arguments a) { return a[0] < a[1] ? 1.0 : 0.0; }},
    {"<=", ExpressionLevel::relation, [](Arguments a) { return a[0] <= a[1] ? 1.0 : 0.0; }},
    {">", ExpressionLevel::relation, [](Arguments a) { return a[0] > a[1] ? 1.0 : 0.0; }},
    {">=", ExpressionLevel::relation, [](Arguments a) { return a[0] >= a[1] ? 1.0 : 0.0; }},
    {"+", ExpressionLevel::sum, [](Arguments a) { return a[0] + a[1]; }},
    {"-", ExpressionLevel::sum, [](Arguments a) { return a[0] - a[1]; }},
    {"*", ExpressionLevel::product, [](Arguments a) { return a[0] * a[1]; }},
    {"/", ExpressionLevel::product, [](Arguments a) { return a[0] / a[1]; }},
    {"%", ExpressionLevel::product, [](Arguments a) { return std::fmod(a[0], a[1]); }},
    {"^", ExpressionLevel::power, [](Arguments a) { return std::pow(a[0], a[1]); }},
});

}  // namespace

const ExpressionOperator* find_expression_operator(std::string_view symbol) {
  const auto found =
      std::find_if(operators.begin(), operators.end(), [&](const auto& row) { return row.symbol == symbol; });
  return found == operators.end() ? nullptr : &*found;
}

}  // namespace contactsim
