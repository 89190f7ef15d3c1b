// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace contactsim {

/// A text on lines of at most 100 columns, ended by a newline. Words stay whole, and parts of a choice
/// between bars; a word that is longer has its line for itself.
///   first_column  where the text begins on its first line
///   indent        where later lines begin
std::string wrap_text(const std::string& text, std::size_t first_column, std::size_t indent);

}  // namespace contactsim
