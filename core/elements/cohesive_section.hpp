// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/elements/model_block.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The mesh with the shapes that COHESIVE SECTION gives to blocks of HEX8 and WEDGE6: cohesive elements,
/// which are as if absent for skins and contact. To be called once, before contact and model are made.
Mesh with_cohesive_blocks(const SimulationDefinition& definition, const Region& region, Mesh mesh);

/// Builds a block of cohesive elements. Errors, at `location`: elements whose faces, of nodes 1 to 4 (or 3)
/// and of the others, do not lie opposite each other.
///   mesh_block  position in the mesh, of cohesive shape
///   density     0: only the nodes' other elements have mass [mass/length^3]
std::optional<ModelBlock> make_cohesive_block(const Mesh& mesh, std::uint32_t mesh_block,
                                              const TractionLaw& law, double density,
                                              const DeckLocation& location, Diagnostics& diagnostics);

}  // namespace contactsim
