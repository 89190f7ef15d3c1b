// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/definition/expression.hpp"
#include "core/functions/expression_functions.hpp"

namespace contactsim {

/// Takes an expression apart, in postfix order. Throws ExpressionError.
/// Both dialects: numbers, names, calls, ( ), ?: and the rows of expression_operators().
/// function: statements `name = value;` before the last; names may hold full stops; what Sierra and C read
/// differently, where only parentheses say what is meant, is an error: -2^2, a^b^c, a && b || c, a < b < c.
/// aprepro: strings, assignments wherever a value may stand, ++ and --, [x]; names may hold colons.
///   base  added to the offsets of items and errors, which then count in the text around the expression
/// Source: Sierra decks' EVALUATE EXPRESSION (Trilinos STK expreval); SEACAS Aprepro, tables of operators.
std::vector<ExpressionItem> parse_expression(std::string_view text, ExpressionDialects dialect,
                                             std::size_t base = 0);

/// An expression of a function or of user output; a mistake in it is kept for whoever uses it.
///   location  of the text, or of the quote before it
DeckExpression read_deck_expression(DeckLocation location, std::string text);

/// Whether the text is one of Aprepro's names: a letter or _, then letters, digits, _ and colons.
bool is_aprepro_name(std::string_view text);

}  // namespace contactsim
