// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/definition/finite_element_model.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// All that a deck may call each block of a mesh: its own name, those of the assemblies that hold it, aliases
/// of either. Returns [n_blocks].
std::vector<std::vector<std::string>> find_block_names(const Mesh& mesh, std::span<const MeshAlias> aliases);

}  // namespace contactsim
