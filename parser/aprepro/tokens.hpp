// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace contactsim {

/// What is wrong in an expression, and where.
struct ApreproError {
  std::size_t offset = 0;  ///< into the text that was given
  int length = 1;
  std::string text;
  std::string hint = {};
};

enum class ApreproTokenKind : std::uint8_t { number, string, name, symbol, end };

struct ApreproToken {
  ApreproTokenKind kind = ApreproTokenKind::end;
  std::string_view text;   ///< of a string without its quotes; into the text that was given
  double number = 0.0;     ///< of a number
  std::size_t offset = 0;  ///< into the text that was given
};

/// Cuts an expression into tokens, the last of kind end. A name may hold colons. Throws ApreproError, whose
/// offsets, like those of the tokens, have `base` added.
std::vector<ApreproToken> read_aprepro_tokens(std::string_view text, std::size_t base);

/// Whether the text is a name: a letter or _, then letters, digits, _ and colons.
bool is_aprepro_name(std::string_view text);

}  // namespace contactsim
