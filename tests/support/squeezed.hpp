// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim::test {

/// The text with runs of blanks made one and those at line starts and ends dropped.
inline std::string squeezed(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool is_blank_before = result.empty() || result.back() == ' ' || result.back() == '\n';
    if (c == ' ' && is_blank_before) continue;
    if (c == '\n' && !result.empty() && result.back() == ' ') result.pop_back();
    result += c;
  }
  return result;
}

}  // namespace contactsim::test
