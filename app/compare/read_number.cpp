// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/read_number.hpp"

#include <charconv>

namespace contactsim {

namespace {

template <class Number>
std::optional<Number> read_whole(std::string_view text) {
  // from_chars knows no plus sign.
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number number{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<double> read_number(std::string_view text) { return read_whole<double>(text); }

std::optional<std::int64_t> read_integer(std::string_view text) { return read_whole<std::int64_t>(text); }

}  // namespace contactsim
