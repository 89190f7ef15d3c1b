// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

/// Reads every node set. Throws FileError for nodes outside 1..n_nodes; warns of distribution factors that do
/// not match and drops them.
std::vector<NodeSet> read_node_sets(const ExodusFile& file, std::uint32_t n_nodes, Diagnostics& warnings);

/// Reads every side set. Throws FileError for elements that do not exist and for side numbers that the
/// element's shape does not have; sides of unknown shapes may be 1 to 8. Warns of distribution factors that
/// are neither one per node of each side nor one per side, and drops them.
std::vector<SideSet> read_side_sets(const ExodusFile& file, std::span<const ElementBlock> blocks,
                                    Diagnostics& warnings);

}  // namespace contactsim
