// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "app/report/stored_names.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/stored_variables.hpp"

namespace contactsim {

/// When elements die and what faces that exposes, as the stored variable death_status tells.
struct ElementLife {
  /// [n_elements] position of the first stored time at which it is dead; n_times of those that live on. Empty
  /// when no element dies, or nothing tells.
  std::vector<std::uint32_t> dead_from;
  /// Faces that lie inside at the start, and the position of the first stored time at which they are outside.
  std::map<ElementSide, std::uint32_t> exposed;
};

/// Looks at all stored times. Throws FileError.
///   names  what death_status is called on the file
ElementLife find_element_life(const StoredVariables& stored, const Mesh& mesh, const StoredNames& names);

}  // namespace contactsim
