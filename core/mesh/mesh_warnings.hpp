// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Warns of what a mesh may hold by mistake: midside nodes that a neighbour does not have, elements on the
/// nodes of others, an element that spans the model where others of its block are small.
///   location  of the finite element model in the deck
void warn_of_mesh(const Mesh& mesh, const DeckLocation& location, Diagnostics& diagnostics);

}  // namespace contactsim
