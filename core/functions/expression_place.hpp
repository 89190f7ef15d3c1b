// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/definition/expression.hpp"

namespace contactsim {

/// Where in the deck the character at `offset` of an expression stands, through quotes and continued lines;
/// the expression's own place when the deck's text is not the expression's, as after Aprepro.
DeckLocation locate(const DeckExpression& expression, std::size_t offset);

}  // namespace contactsim
