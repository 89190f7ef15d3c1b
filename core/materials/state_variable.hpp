// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace contactsim {

/// A part of a material's state that can be written out.
struct StateVariable {
  std::string_view name;         ///< as decks ask for it, lower case
  std::size_t first = 0;         ///< its place in the state
  std::size_t n_components = 1;  ///< 1, or 6 of a symmetric tensor
  std::string_view help;         ///< one line with the dimension
};

}  // namespace contactsim
