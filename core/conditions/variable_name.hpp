// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace contactsim {

/// A variable of a deck in its two parts: coordinates(x) is "coordinates" and "x".
struct VariableName {
  std::string name;       ///< folded
  std::string component;  ///< folded, "" when none is picked
};

VariableName split_variable(std::string_view text);

/// Position of a component by its letters or its number from 1; nothing when the variable has no such one.
///   n_components  1, 3 (x y z) or 6 (xx yy zz xy yz zx)
std::optional<std::size_t> find_component(std::string_view component, std::size_t n_components);

/// The letters of a component of 3 or 6: "x", "xy"; "" of a scalar.
std::string_view component_letters(std::size_t component, std::size_t n_components);

}  // namespace contactsim
