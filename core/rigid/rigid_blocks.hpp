// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Positions in the mesh of the blocks whose sections make them parts of a rigid body, ascending.
std::vector<std::uint32_t> find_rigid_blocks(const SimulationDefinition& definition, const Region& region,
                                             const Mesh& mesh, const RigidBodyDefinition& body);

}  // namespace contactsim
