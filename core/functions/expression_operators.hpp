// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "core/functions/expression_functions.hpp"

namespace contactsim {

/// How strongly operators between two values bind; higher binds more, equal ones group to the left.
enum class ExpressionLevel : std::uint8_t {
  lowest,
  logical_or,
  logical_and,
  relation,
  sum,
  product,
  power,
  prefix
};

/// An operator between two values.
struct ExpressionOperator {
  std::string_view symbol;
  ExpressionLevel level = ExpressionLevel::lowest;
  ExpressionFunction::Body body = nullptr;  ///< of two arguments
};

/// The operator of a symbol; null for another symbol.
const ExpressionOperator* find_expression_operator(std::string_view symbol);

}  // namespace contactsim
