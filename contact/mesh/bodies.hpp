// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What solids and shells of a mesh join to one body, by the nodes that they share. Lines and particles join
/// nothing.
/// Returns [n_nodes] the first node of the body; of a node without solids and shells itself.
std::vector<std::uint32_t> find_bodies(const Mesh& mesh);

}  // namespace contactsim
