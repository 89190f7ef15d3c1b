// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace contactsim {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_part(char c) { return is_name_start(c) || is_digit(c) || c == ':'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// Longer ones first, so that the first that fits is the right one.
constexpr std::array<std::string_view, 31> symbols = {
    "**=", "+=", "-=", "*=", "/=", "^=", "++", "--", "**", "//", "==", "!=", "<=", ">=", "&&", "||",
    "=",   "+",  "-",  "*",  "~",  "/",  "%",  "^",  "(",  ")",  ",",  ";",  ":",  "?",  "<"};
constexpr std::string_view further_symbols = ">![]";

class Reader {
 public:
  Reader(std::string_view text, std::size_t base) : text_(text), base_(base) {}
  ApreproToken next();

 private:
  ApreproToken read_number();
  ApreproToken read_string();
  ApreproToken read_symbol();
  ApreproToken take(ApreproTokenKind kind, std::size_t length);

  std::string_view text_;
  std::size_t base_;
  std::size_t at_ = 0;
};

ApreproToken Reader::next() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  if (at_ == text_.size()) return take(ApreproTokenKind::end, 0);
  const char c = text_[at_];
  const bool starts_fraction = c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]);
  if (is_digit(c) || starts_fraction) return read_number();
  if (c == '"' || c == '\'') return read_string();
  if (!is_name_start(c)) return read_symbol();
  const auto end =
      std::find_if_not(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(), is_name_part);
  return take(ApreproTokenKind::name, static_cast<std::size_t>(end - text_.begin()) - at_);
}

ApreproToken Reader::read_number() {
  const char* begin = text_.data() + at_;
  double value = 0.0;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
  const auto length = static_cast<std::size_t>(end - begin);
  if (error == std::errc::result_out_of_range) {
    throw ApreproError{base_ + at_, static_cast<int>(length),
                       fmt::format("the number {} is out of range", text_.substr(at_, length))};
  }
  ApreproToken token = take(ApreproTokenKind::number, length);
  token.number = value;
  return token;
}

ApreproToken Reader::read_string() {
  const char quote = text_[at_];
  const std::size_t end = text_.find_first_of(quote == '"' ? "\"\n" : "'", at_ + 1);
  if (end == std::string_view::npos || text_[end] == '\n') {
    throw ApreproError{base_ + at_, 1, fmt::format("the string {} is never closed", quote),
                       quote == '"' ? "only a string in '...' may span lines" : ""};
  }
  ApreproToken token = take(ApreproTokenKind::string, end + 1 - at_);
  token.text = token.text.substr(1, token.text.size() - 2);
  return token;
}

ApreproToken Reader::read_symbol() {
  const std::string_view rest = text_.substr(at_);
  const auto found =
      std::find_if(symbols.begin(), symbols.end(), [&](std::string_view s) { return rest.starts_with(s); });
  if (found != symbols.end()) return take(ApreproTokenKind::symbol, found->size());
  if (further_symbols.find(rest[0]) != std::string_view::npos) return take(ApreproTokenKind::symbol, 1);
  const bool is_printable = rest[0] > ' ' && rest[0] < 0x7f;
  throw ApreproError{base_ + at_, 1,
                     is_printable ? fmt::format("unexpected '{}' in an expression", rest[0])
                                  : fmt::format("unexpected character {:#04x} in an expression",
                                                static_cast<unsigned char>(rest[0]))};
}

ApreproToken Reader::take(ApreproTokenKind kind, std::size_t length) {
  const ApreproToken token{kind, text_.substr(at_, length), 0.0, base_ + at_};
  at_ += length;
  return token;
}

}  // namespace

std::vector<ApreproToken> read_aprepro_tokens(std::string_view text, std::size_t base) {
  Reader reader(text, base);
  std::vector<ApreproToken> tokens;
  do {
    tokens.push_back(reader.next());
  } while (tokens.back().kind != ApreproTokenKind::end);
  return tokens;
}

bool is_aprepro_name(std::string_view text) {
  return !text.empty() && is_name_start(text[0]) && std::all_of(text.begin(), text.end(), is_name_part);
}

}  // namespace contactsim
