// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/conditions/kinematic_constraints.hpp"
#include "core/definition/declarations.hpp"
#include "core/dynamics/rigid_bodies.hpp"
#include "core/dynamics/state.hpp"
#include "core/dynamics/subcycles.hpp"
#include "core/elements/minimum_nodal_mass.hpp"
#include "core/elements/model_block.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What a region makes of a mesh: elements with their materials, masses, fixed and prescribed nodes. Const
/// after set-up; the mesh must outlive it.
struct Model {
  const Mesh* mesh = nullptr;
  std::vector<ModelBlock> blocks;  ///< in the order of the mesh, blocks of no elements left out
  Eigen::RowVectorXd mass;         ///< [n_nodes] lumped; minimum_nodal_mass without elements [mass]
  Eigen::RowVectorXd inertia;  ///< [n_nodes] lumped, about any axis; empty when no node turns [mass length^2]
  KinematicConstraints kinematic_constraints;
  KinematicConstraints rotation_constraints;  ///< of the nodes' rotations
  RigidBodies rigid;
  Subcycles subcycles;
};

/// The masses of the nodes, as Model::mass.
Eigen::RowVectorXd lumped_mass(const Mesh& mesh, std::span<const ModelBlock> blocks);

/// The rotational inertias of the nodes, as Model::inertia.
Eigen::RowVectorXd lumped_inertia(const Mesh& mesh, std::span<const ModelBlock> blocks);

/// Builds the model of a region. Errors: blocks without material, with one that is not supported or with a
/// density that is missing; element shapes and section formulations that are not supported; wrong conditions.
Model make_model(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                 Diagnostics& diagnostics);

}  // namespace contactsim
