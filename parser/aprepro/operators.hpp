// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parser/aprepro/tokens.hpp"
#include "parser/aprepro/values.hpp"

namespace contactsim {

/// How strongly operators bind; higher binds more. Assignments and steps (++ --) belong to their names.
/// Source: SEACAS Aprepro, tables of operators.
enum class ApreproLevel {
  lowest = 0,
  ternary = 5,
  logical_or = 6,
  logical_and = 7,
  relation = 8,
  sum = 9,
  product = 10,
  power = 12,
  concatenation = 14
};

/// The level of an operator that stands between two values (or of the ? of ?:), nothing for another symbol.
std::optional<ApreproLevel> find_aprepro_level(std::string_view symbol);

/// Throws the ApreproError of a token.
[[noreturn]] void fail_at(const ApreproToken& at, std::string text, std::string hint = "");

/// Whether a value counts as true: a number other than 0, a string that is not empty.
bool is_true(const ApreproValue& value);

/// The number in a value that the operator `at` takes. Throws ApreproError when it is a string.
double number_of(const ApreproValue& value, const ApreproToken& at);

/// The value of `a operator b` for an operator between two values or of an assignment (+= and so on). Throws
/// ApreproError when the operator does not take such values, and when the result is not a finite number or a
/// string of at most 1 MiB.
ApreproValue combine(const ApreproValue& a, const ApreproToken& at, const ApreproValue& b);

}  // namespace contactsim
