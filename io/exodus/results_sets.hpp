// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/mesh.hpp"
#include "io/exodus/exodus_draft.hpp"

namespace contactsim {

/// Adds side sets and node sets with their distribution factors to a file, under the names of Mesh::name. The
/// mesh must live until the draft is written.
void add_sets(const Mesh& mesh, ExodusDraft& draft);

/// Adds the assemblies that have members; those of kinds that contactsim does not use have none.
void add_assemblies(const Mesh& mesh, ExodusDraft& draft);

}  // namespace contactsim
