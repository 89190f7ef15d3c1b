// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/output_variable.hpp"

#include <array>
#include <utility>

namespace contactsim {

std::string canonical_variable_name(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> older{{
      {"kineticenergy", "kinetic_energy"},
      {"internalenergy", "internal_energy"},
      {"externalenergy", "external_energy"},
      {"reactions", "reaction"},
  }};
  std::string folded = fold(name);
  for (const auto& [old_name, new_name] : older) {
    if (folded == old_name) return std::string(new_name);
  }
  return folded;
}

}  // namespace contactsim
