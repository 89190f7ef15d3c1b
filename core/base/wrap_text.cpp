// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/wrap_text.hpp"

#include <vector>

namespace contactsim {

namespace {

constexpr std::size_t line_width = 100;

/// The parts of a text that stay on one line: its words, cut behind each '|' of a choice too. A part that
/// follows a blank begins with it.
std::vector<std::string> unbroken_parts(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    const bool begins_part = c == ' ' || parts.back().ends_with('|');
    if (begins_part && !parts.back().empty()) parts.emplace_back();
    parts.back() += c;
  }
  return parts;
}

}  // namespace

std::string wrap_text(const std::string& text, std::size_t first_column, std::size_t indent) {
  std::string out;
  std::size_t at = first_column;
  for (const std::string& part : unbroken_parts(text)) {
    const bool breaks = !out.empty() && at + part.size() > line_width;
    const std::string shown = breaks && part.starts_with(' ') ? part.substr(1) : part;
    if (breaks) {
      out += '\n' + std::string(indent, ' ');
      at = indent;
    }
    out += shown;
    at += shown.size();
  }
  return out + '\n';
}

}  // namespace contactsim
