// SPDX-License-Identifier: BSD-3-Clause
#include "core/output_field.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

namespace contactsim {

std::string_view to_string(FieldLocation location) {
  constexpr std::array<std::string_view, 3> names{"nodal", "element", "global"};
  return names[static_cast<std::size_t>(location)];
}

std::string component_name(std::string_view name, int component, int n_components) {
  assert(0 <= component && component < n_components);
  constexpr std::array<std::string_view, 3> vector{"x", "y", "z"};
  // The first six are the symmetric tensor.
  constexpr std::array<std::string_view, 9> tensor{"xx", "yy", "zz", "xy", "yz", "zx", "yx", "zy", "xz"};
  const auto c = static_cast<std::size_t>(component);
  if (n_components == 1) return std::string(name);
  if (n_components == 3) return fmt::format("{}_{}", name, vector[c]);
  if (n_components == 6 || n_components == 9) return fmt::format("{}_{}", name, tensor[c]);
  return fmt::format("{}_{:0{}}", name, component + 1, fmt::formatted_size("{}", n_components));
}

}  // namespace contactsim
