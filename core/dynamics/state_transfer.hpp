// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/definition/procedure.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// What a model takes over of the state that another one of the same mesh has come to: PROCEDURAL TRANSFER.
struct StateTransfer {
  /// [n_blocks] of each block, its position in the other model; absent: it starts from the mesh
  std::vector<std::optional<std::size_t>> sources;
  bool takes_velocities = true;  ///< else nodes start with those of the initial conditions
  /// [n_bodies] of each rigid body, its position in the other model; absent: it starts from the mesh
  std::vector<std::optional<std::size_t>> bodies = {};

  /// Whether no block starts from the mesh.
  bool is_whole() const;
};

/// The blocks that transfers name. Errors: names that the mesh does not have, another mesh, and other
/// materials, elements or sections than those of the other model, rigid bodies of other nodes.
///   scope    of the region that takes over
///   earlier  the other model
StateTransfer find_state_transfer(const ConditionScope& scope, std::span<const ProceduralTransfer> transfers,
                                  const Model& earlier, const Model& model);

/// Has shells of an explicit model resist drilling as those do that they take over from: moments about their
/// normals are part of that equilibrium.
void keep_drilling(const StateTransfer& transfer, const Model& earlier, Model& model);

/// Takes over, of the blocks that do: stresses, what materials, hourglass modes and drilling remember, which
/// elements have died or are dying; of their nodes coordinates, rotations and velocities; and where rigid
/// bodies are and how they have turned. The energies go on when all blocks do, their error begins anew.
///   state  at the start
void take_over(const StateTransfer& transfer, const Model& earlier, const State& from, const Model& model,
               State& state);

}  // namespace contactsim
