// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/definition/condition_lines.hpp"
#include "core/definition/entity_set.hpp"

/// The state at the start. Source: Sierra/SM 5.22, chapter 7.
namespace contactsim {

/// BEGIN INITIAL VELOCITY: along components or a direction by magnitude or function, or about an axis by
/// angular velocity. Components leave the others as they are, a direction or axis sets the whole vector. Of
/// several blocks on a node the last counts.
struct InitialVelocity {
  DeckName name;
  EntitySet set;
  DirectionChoice direction;
  std::optional<double> magnitude;         ///< [length/time]
  std::optional<double> angular_velocity;  ///< about DirectionChoice::cylindrical_axis [1/time]
  ScaledFunction function;                 ///< position [length] or time [time] to velocity [length/time]
};

/// Where an initialised variable lives.
enum class VariableType : std::uint8_t { node, edge, face, element, global };

/// BEGIN INITIAL CONDITION: a variable's values at the start.
struct InitialCondition {
  DeckName name;
  EntitySet set;
  std::optional<DeckName> variable;  ///< INITIALIZE VARIABLE NAME
  std::optional<VariableType> type;
  std::vector<double> magnitude;  ///< one value per component [of the variable]; empty: read from the mesh
  MeshVariable mesh_variable;
  double scale_factor = 1.0;  ///< of what is read [1]
};

}  // namespace contactsim
