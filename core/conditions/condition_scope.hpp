// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/time_control.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/stored_variables.hpp"
#include "core/rigid/rigid_nodes.hpp"

namespace contactsim {

/// What the conditions of a region are made from, and where their errors go.
struct ConditionScope {
  const SimulationDefinition& definition;
  const Region& region;
  /// Of the region's procedure: the periods; may be empty.
  std::span<const TimeSteppingBlock> time_stepping_blocks;
  const Mesh& mesh;
  Diagnostics& diagnostics;
  const StoredVariables* stored = nullptr;  ///< results of the mesh file, for READ VARIABLE; null: none
  const RigidNodes* rigid = nullptr;        ///< of the model; null: no rigid bodies

  /// Of the run [time].
  double start_time() const {
    return time_stepping_blocks.empty() ? 0.0 : time_stepping_blocks.front().start_time;
  }
};

/// A condition block as messages call it.
struct ConditionLabel {
  std::string what;  ///< such as "the prescribed velocity"
  DeckLocation location;
};

/// "the prescribed velocity at plate.i:12:3"
inline std::string to_string(const ConditionLabel& label) {
  return label.location.is_known() ? label.what + " at " + to_string(label.location) : label.what;
}

}  // namespace contactsim
