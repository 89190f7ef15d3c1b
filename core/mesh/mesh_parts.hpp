// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A copy of all that a mesh is made of, with the ids of every node and element.
MeshParts parts_of(const Mesh& mesh);

/// A copy of a mesh with node sets besides its own; they get the ids that follow the largest.
Mesh with_node_sets(const Mesh& mesh, std::span<const NodeSet> more);

}  // namespace contactsim
