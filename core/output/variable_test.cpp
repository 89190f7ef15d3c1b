// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/variable_test.hpp"

#include <array>

namespace contactsim {

bool holds(const VariableTest& test, double value) {
  switch (test.comparison) {
    case Comparison::less:
      return value < test.value;
    case Comparison::less_equal:
      return value <= test.value;
    case Comparison::equal:
      return value == test.value;
    case Comparison::greater_equal:
      return value >= test.value;
    case Comparison::greater:
      break;
  }
  return value > test.value;
}

std::string_view symbol(Comparison comparison) {
  constexpr std::array<std::string_view, 5> symbols{"<", "<=", "=", ">=", ">"};
  return symbols[static_cast<std::size_t>(comparison)];
}

}  // namespace contactsim
