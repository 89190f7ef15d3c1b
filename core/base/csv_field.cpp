// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/csv_field.hpp"

namespace contactsim {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += '"';
  }
  return quoted + '"';
}

}  // namespace contactsim
