// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Faces of six nodes beside faces with the same corners that do not have their midside nodes.
struct HangingFaces {
  std::size_t n = 0;
  ElementSide first;   ///< of six nodes
  ElementSide beside;  ///< what lies on it
};

/// Those of a mesh; nothing when there are none. Time proportional to the number of ten-node tetrahedra.
std::optional<HangingFaces> find_hanging_faces(const Mesh& mesh);

}  // namespace contactsim
