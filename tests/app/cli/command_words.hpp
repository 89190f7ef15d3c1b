// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/cli/options.hpp"

namespace contactsim::test {

/// What a command line of these words, behind the program's name, means.
inline CommandLine read_words(std::vector<const char*> words) {
  words.insert(words.begin(), "contactsim");
  return read_command_line(static_cast<int>(words.size()), words.data());
}

}  // namespace contactsim::test
