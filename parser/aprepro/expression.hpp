// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "core/definition/expression.hpp"
#include "parser/aprepro/functions.hpp"
#include "parser/aprepro/values.hpp"

namespace contactsim {

/// Evaluates one expression. Both sides of && || ?: are always evaluated. A name without value is 0 and is
/// warned about ("aprepro-undefined"). Throws ExpressionError.
/// Source: SEACAS Aprepro, tables of operators.
ApreproValue evaluate_aprepro(std::span<const ExpressionItem> expression, ApreproState& state);

/// The same of an expression's text.
///   base  added to the offsets of errors and warnings, which then count in the text around the expression
ApreproValue evaluate_aprepro(std::string_view expression, std::size_t base, ApreproState& state);

}  // namespace contactsim
