// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string>

namespace contactsim {

/// A check of the command line that a value is a finite number, of some sign. CLI11's own writes the largest
/// number that there is with all of its 309 digits.
inline CLI::Validator finite_number(bool may_be_zero) {
  const auto check = [may_be_zero](const std::string& text) -> std::string {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, value);
    const bool is_number = failure == std::errc() && stop == end && std::isfinite(value);
    if (is_number && (value > 0.0 || (may_be_zero && value == 0.0))) return "";
    return fmt::format("expected a number {} 0, found '{}'", may_be_zero ? ">=" : ">", text);
  };
  return {check, ""};
}
inline CLI::Validator positive_number() { return finite_number(false); }
inline CLI::Validator non_negative_number() { return finite_number(true); }

}  // namespace contactsim
