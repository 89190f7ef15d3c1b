// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "io/exodus/exodus_draft.hpp"

namespace contactsim {

/// The ids of all nodes, or of all elements, in the order of the file.
std::vector<std::int64_t> make_node_map(const Mesh& mesh);
std::vector<std::int64_t> make_element_map(const Mesh& mesh);

/// Adds nodes, id maps and element blocks with their attributes to a file. Names are those of Mesh::name,
/// types those of the topology table; a map that is 1..n is left out. The mesh must live until the draft is
/// written. Precondition: blocks of unknown shape are empty.
void add_mesh(const Mesh& mesh, ExodusDraft& draft);

}  // namespace contactsim
