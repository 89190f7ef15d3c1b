// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/expression_tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "core/functions/expression.hpp"

namespace contactsim {

namespace {

using Kind = ExpressionTokenKind;
using Token = ExpressionToken;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_part(char c) { return is_name_start(c) || is_digit(c) || c == '.'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// Longer ones first, so that the first that fits is the right one.
constexpr std::array<std::string_view, 22> symbols = {"==", "!=", "<=", ">=", "&&", "||", "+", "-",
                                                      "*",  "/",  "%",  "^",  "<",  ">",  "!", "?",
                                                      ":",  "(",  ")",  ",",  ";",  "="};

Token read_number(std::string_view text, std::size_t at) {
  const char* begin = text.data() + at;
  Token token{Kind::number, {}, 0.0, at};
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), token.number);
  token.text = text.substr(at, static_cast<std::size_t>(end - begin));
  if (error == std::errc()) return token;
  throw ExpressionError{at, static_cast<int>(token.text.size()),
                        fmt::format("the number {} is out of range", token.text)};
}

Token read_symbol(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  const auto found =
      std::find_if(symbols.begin(), symbols.end(), [&](std::string_view s) { return rest.starts_with(s); });
  if (found != symbols.end()) return {Kind::symbol, rest.substr(0, found->size()), 0.0, at};
  if (rest[0] == '[' || rest[0] == ']') {
    throw ExpressionError{at, 1, "components in brackets are not supported",
                          "a vector variable v has the components v_x v_y v_z"};
  }
  const bool is_printable = rest[0] > ' ' && rest[0] < 0x7f;
  throw ExpressionError{at, 1,
                        is_printable ? fmt::format("unexpected '{}' in an expression", rest[0])
                                     : fmt::format("unexpected character {:#04x} in an expression",
                                                   static_cast<unsigned char>(rest[0]))};
}

Token read_token(std::string_view text, std::size_t at) {
  if (at == text.size()) return {Kind::end, {}, 0.0, at};
  const char c = text[at];
  const bool starts_fraction = c == '.' && at + 1 < text.size() && is_digit(text[at + 1]);
  if (is_digit(c) || starts_fraction) return read_number(text, at);
  if (!is_name_start(c)) return read_symbol(text, at);
  const std::string_view rest = text.substr(at);
  const auto end = std::find_if_not(rest.begin(), rest.end(), is_name_part);
  return {Kind::name, rest.substr(0, static_cast<std::size_t>(end - rest.begin())), 0.0, at};
}

}  // namespace

std::vector<ExpressionToken> read_expression_tokens(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t at = 0;
  do {
    while (at < text.size() && is_blank(text[at])) ++at;
    tokens.push_back(read_token(text, at));
    at += tokens.back().text.size();
  } while (tokens.back().kind != Kind::end);
  return tokens;
}

}  // namespace contactsim
