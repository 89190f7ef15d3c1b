// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/definition/expression.hpp"
#include "core/functions/expression_functions.hpp"

namespace contactsim {

/// How strongly operators bind; higher binds more. Equal ones group to the left, powers to the right.
enum class ExpressionLevel : std::uint8_t {
  definition,  ///< name = value, at the start of a statement
  assignment,  ///< name = value, wherever a value may stand
  logical_or,
  logical_and,
  relation,
  sum,
  product,
  prefix,
  power,
  concatenation,
  step,    ///< ++ and -- at a name
  bracket  ///< [x]
};

/// An operator of expressions: one row of the table.
struct ExpressionOperator {
  std::string_view symbol;
  ExpressionLevel level = ExpressionLevel::sum;
  ExpressionDialects dialects = ExpressionDialects::all;
  ExpressionFunction::Body body = nullptr;  ///< of the values on both sides, or of the one behind; null: none
};

/// All rows. A symbol may stand in several: before a value or between two, and in different dialects.
/// Source: Trilinos STK expreval and SEACAS Aprepro, tables of operators.
std::span<const ExpressionOperator> expression_operators();

/// Throws the ExpressionError of an item.
[[noreturn]] void fail_at(const ExpressionItem& item, std::string text, std::string hint = "");

}  // namespace contactsim
