// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A mesh with more node sets, whose ids follow those that it has.
Mesh with_node_sets(const Mesh& mesh, std::span<const NodeSet> more);

}  // namespace contactsim
