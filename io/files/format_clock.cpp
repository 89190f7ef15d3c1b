// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/format_clock.hpp"

#include <array>

namespace contactsim {

std::string format_clock(std::time_t time, const std::string& format) {
  std::array<char, 256> text{};
  std::tm local{};
  localtime_r(&time, &local);
  const std::size_t n = std::strftime(text.data(), text.size(), format.c_str(), &local);
  return {text.data(), n};
}

}  // namespace contactsim
