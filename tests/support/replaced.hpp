// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim::test {

/// The text with the first place of a part, which must be there, replaced.
inline std::string replaced(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);
}

}  // namespace contactsim::test
