// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Solids or shells that have the corner nodes of an earlier element of their family, in any order.
struct CoincidentElements {
  std::size_t n = 0;
  ElementIndex first, beside;  ///< the first of them, and the earlier element
};

/// Those of a mesh; nothing when there are none. Time proportional to the number of elements.
std::optional<CoincidentElements> find_coincident_elements(const Mesh& mesh);

}  // namespace contactsim
