// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/variable_name.hpp"

#include "core/base/names.hpp"

namespace contactsim {

VariableName split_variable(std::string_view text) {
  const std::string folded = fold(text);
  const std::size_t open = folded.find('(');
  if (open == std::string::npos || folded.back() != ')') return {folded, ""};
  return {folded.substr(0, open), folded.substr(open + 1, folded.size() - open - 2)};
}

std::string_view component_letters(std::size_t component, std::size_t n_components) {
  static constexpr std::string_view vector[] = {"x", "y", "z"};
  static constexpr std::string_view tensor[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  if (n_components == 3) return vector[component];
  if (n_components == 6) return tensor[component];
  return "";
}

std::optional<std::size_t> find_component(std::string_view component, std::size_t n_components) {
  for (std::size_t i = 0; i < n_components; ++i) {
    const bool is_number = component == std::to_string(i + 1);
    const bool is_letters = n_components > 1 && component == component_letters(i, n_components);
    if (is_number || is_letters) return i;
  }
  return std::nullopt;
}

}  // namespace contactsim
