// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

/// Reads every element block of an Exodus file, attributes included. A block of a type that is unknown or
/// missing keeps its number of elements and no connectivity. Throws FileError for nodes outside 1..n_nodes,
/// missing connectivity, and counts that disagree with num_elem.
std::vector<ElementBlock> read_blocks(const ExodusFile& file, std::uint32_t n_nodes, Diagnostics& warnings);

}  // namespace contactsim
