// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A copy of all that a mesh is made of, with the ids of every node and element.
MeshParts parts_of(const Mesh& mesh);

/// Adds sets besides its own to what a mesh is made of; they get the ids that follow the largest.
void add_sets(std::span<const SideSet> side_sets, std::span<const NodeSet> node_sets, MeshParts& parts);

}  // namespace contactsim
