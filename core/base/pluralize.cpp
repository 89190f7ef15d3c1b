// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/pluralize.hpp"

#include <fmt/format.h>

namespace contactsim {

std::string pluralize(std::size_t n, std::string_view singular, std::string_view plural) {
  if (n == 1) return fmt::format("1 {}", singular);
  return plural.empty() ? fmt::format("{} {}s", n, singular) : fmt::format("{} {}", n, plural);
}

}  // namespace contactsim
