// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/functions/expression_operators.hpp"
#include "parser/aprepro/values.hpp"

namespace contactsim {

/// Whether a value counts as true: a number other than 0, a string that is not empty.
bool is_true(const ApreproValue& value);

/// The value of an operator before a value. Throws ExpressionError when the operator does not take it.
ApreproValue combine(const ExpressionItem& op, const ApreproValue& value);

/// The value of an operator between two values or of an assignment (+= and so on). Throws ExpressionError
/// when the operator does not take such values, and when the result is not a finite number or a string of at
/// most 1 MiB.
ApreproValue combine(const ApreproValue& a, const ExpressionItem& op, const ApreproValue& b);

}  // namespace contactsim
