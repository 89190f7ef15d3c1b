// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/clean_text.hpp"

#include <algorithm>

namespace contactsim {

std::string clean_text(std::string_view stored) {
  const std::string_view text = stored.substr(0, stored.find('\0'));
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return "";
  std::string cleaned(text.substr(first, text.find_last_not_of(' ') - first + 1));
  std::replace_if(
      cleaned.begin(), cleaned.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7f; },
      '_');
  return cleaned;
}

}  // namespace contactsim
