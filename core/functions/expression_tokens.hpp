// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace contactsim {

enum class ExpressionTokenKind : std::uint8_t { number, name, symbol, end };

struct ExpressionToken {
  ExpressionTokenKind kind = ExpressionTokenKind::end;
  std::string_view text;   ///< into the text that was given
  double number = 0.0;     ///< of a number
  std::size_t offset = 0;  ///< into the text that was given
};

/// Cuts an expression into tokens, the last of kind end. A name is a letter or _, then letters, digits, _ and
/// full stops. Throws ExpressionError.
std::vector<ExpressionToken> read_expression_tokens(std::string_view text);

}  // namespace contactsim
