// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/text_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

template <class T>
T number_of(std::string_view text, const TextWords& words, const char* what) {
  T value{};
  const std::string_view digits = text.starts_with('+') && !text.starts_with("+-") ? text.substr(1) : text;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // Words such as nan and inf are numbers to from_chars.
  if (failure != std::errc() || end != digits.data() + digits.size() ||
      !std::isfinite(static_cast<double>(value)))
    words.fail(fmt::format("expected {}, found '{}'", what, text));
  return value;
}

}  // namespace

std::int64_t integer_of(std::string_view text, const TextWords& words) {
  return number_of<std::int64_t>(text, words, "a whole number");
}

double real_of(std::string_view text, const TextWords& words) {
  return number_of<double>(text, words, "a number");
}

TextWords::TextWords(const std::string& path) : path_(path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 65536> part{};
  while (file) {
    file.read(part.data(), part.size());
    text_.append(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  // A folder can be opened, but not read.
  if (!file.eof() || file.bad()) throw FileError(path, "cannot be read");
}

void TextWords::skip_blanks() {
  for (; at_ < text_.size() && is_blank(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
}

bool TextWords::is_at_end() {
  skip_blanks();
  return at_ >= text_.size();
}

std::string_view TextWords::word() {
  if (is_at_end()) fail("the file ends here, in the middle of something");
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
  return std::string_view(text_).substr(begin, at_ - begin);
}

std::int64_t TextWords::integer() { return integer_of(word(), *this); }
double TextWords::real() { return real_of(word(), *this); }

std::string_view TextWords::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view rest = std::string_view(text_).substr(at_, end - at_);
  at_ = end;
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

void TextWords::fail(const std::string& what) const {
  throw FileError(path_, fmt::format("line {}: {}", line_, what));
}

}  // namespace contactsim
