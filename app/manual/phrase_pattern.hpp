// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "parser/binding/table_text.hpp"

namespace contactsim {

/// The phrases of the deck language that editors colour alike.
struct PhraseSets {
  std::vector<std::string> blocks, commands, ignored, refused;  ///< each phrase once, the longest first
};

/// Every phrase by which a row can be called. What one block refuses and another takes counts as taken.
PhraseSets phrase_sets();

/// The phrases as alternatives of a regular expression, their words parted by `blank`.
///   bar  between alternatives, "|" or "\|"
std::string phrase_pattern(const std::vector<std::string>& phrases, const std::string& blank,
                           const std::string& bar);

}  // namespace contactsim
