// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/elements/model_block.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Adds an error for elements without a positive volume, which have no mass and no gradients, and for a block
/// whose stiffness, density or masses are so large or small that products of them are no numbers.
///   block     of elements that have a material
///   location  of its parameters in the deck
void check_block(const ModelBlock& block, const Mesh& mesh, const DeckLocation& location,
                 Diagnostics& diagnostics);

}  // namespace contactsim
