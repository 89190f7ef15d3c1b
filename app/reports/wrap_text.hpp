// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace contactsim {

/// Columns of a line that is read: of the log, of what is printed, of comparisons.
inline constexpr std::size_t line_width = 120;

/// Characters of a text in UTF-8: what it takes of a line.
std::size_t n_columns(std::string_view text);

/// The text with lines of at most line_width columns, broken at blanks. A word alone may be longer: names and
/// paths stay whole.
///   indent  columns before what is left of a line that was broken
std::string wrap_text(std::string_view text, std::size_t indent = 6);

}  // namespace contactsim
