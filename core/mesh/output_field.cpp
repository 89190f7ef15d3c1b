// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/output_field.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

namespace contactsim {

std::string_view to_string(FieldLocation location) {
  constexpr std::array<std::string_view, 3> names{"nodal", "element", "global"};
  return names[static_cast<std::size_t>(location)];
}

int component_count(FieldShape shape) {
  constexpr std::array counts{1, 3, 6, 9, 1};
  return counts[static_cast<std::size_t>(shape)];
}

std::string component_ending(FieldShape shape, int component, int n_components) {
  assert(0 <= component && component < n_components);
  constexpr std::array<const char*, 3> vector{"x", "y", "z"};
  // The first six are the symmetric tensor.
  constexpr std::array<const char*, 9> tensor{"xx", "yy", "zz", "xy", "yz", "zx", "yx", "zy", "xz"};
  const auto c = static_cast<std::size_t>(component);
  switch (shape) {
    case FieldShape::scalar:
      return "";
    case FieldShape::vector:
      return vector.at(c);
    case FieldShape::symmetric_tensor:
    case FieldShape::full_tensor:
      return tensor.at(c);
    case FieldShape::list:
      break;
  }
  return fmt::format("{:0{}}", component + 1, fmt::formatted_size("{}", n_components));
}

std::string with_ending(const std::string& name, const std::string& separator, const std::string& ending) {
  return ending.empty() ? name : name + separator + ending;
}

std::string component_name(const OutputField& field, int component) {
  return with_ending(field.name, field.separator,
                     component_ending(field.shape, component, field.n_components));
}

}  // namespace contactsim
