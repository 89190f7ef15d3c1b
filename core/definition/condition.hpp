// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/definition/condition_lines.hpp"
#include "core/definition/entity_set.hpp"

/// Kinematic conditions. On a rigid body they act on its reference node, and only a block or the rigid body
/// itself may pick it. Displacement is the current position less the mesh's. Source: Sierra/SM 5.22,
/// chapter 7.
namespace contactsim {

/// BEGIN FIXED DISPLACEMENT and BEGIN FIXED ROTATION: nodes are held where they are when the condition
/// begins to act, which is their mesh position if it acts from the start.
struct FixedCondition {
  DeckName name;
  bool is_rotation = false;
  EntitySet set;
  DirectionChoice direction;
  ActivePeriods periods;
};

enum class PrescribedQuantity : std::uint8_t {
  displacement,        ///< [length]
  velocity,            ///< [length/time]
  acceleration,        ///< [length/time^2]
  rotation,            ///< radians [1]
  rotational_velocity  ///< [1/time]
};

/// BEGIN PRESCRIBED DISPLACEMENT | VELOCITY | ACCELERATION | ROTATION | ROTATIONAL VELOCITY: the values come
/// from a function of time or from the mesh file. A displacement counts from the mesh position and is reached
/// at the end of a step; a velocity holds at its middle, an acceleration at its start.
struct PrescribedCondition {
  DeckName name;
  PrescribedQuantity quantity = PrescribedQuantity::displacement;
  EntitySet set;
  DirectionChoice direction;
  ScaledFunction function;  ///< time [time] to the quantity
  MeshVariable variable;    ///< in place of the function; multiplied by the function's scale factor
  ActivePeriods periods;
};

}  // namespace contactsim
