// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/conditions/kinematics.hpp"
#include "core/definition/simulation.hpp"
#include "core/diagnostics.hpp"
#include "core/elements/solid_block.hpp"
#include "core/mesh/mesh.hpp"
#include "core/state.hpp"

namespace contactsim {

/// Mass of nodes that no element gives any: next to none, but so that a force on them is noticed.
inline constexpr double least_mass = 1e-300;

/// What a region makes of a mesh: elements with their materials, masses, held and driven nodes. Const after
/// set-up; the mesh must outlive it.
struct Model {
  const Mesh* mesh = nullptr;
  std::vector<SolidBlock> blocks;  ///< in the order of the mesh, blocks of no elements left out
  Eigen::Matrix3Xd mass;  ///< [3 x n_nodes] lumped, the same in every row; least_mass without elements [mass]
  Kinematics kinematics;
};

/// The masses of the nodes, as Model::mass.
Eigen::Matrix3Xd lumped_mass(const Mesh& mesh, std::span<const SolidBlock> blocks);

/// Builds the model of a region. Errors: blocks without material, with one that is not supported or with a
/// density that is missing; element shapes and section formulations that are not supported; wrong conditions.
Model make_model(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                 Diagnostics& diagnostics);

}  // namespace contactsim
