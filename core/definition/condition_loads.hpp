// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/definition/condition_lines.hpp"
#include "core/definition/entity_set.hpp"

/// Forces that act from outside. Source: Sierra/SM 5.22, chapter 7.
namespace contactsim {

/// BEGIN PRESCRIBED FORCE and BEGIN PRESCRIBED MOMENT: the same load on every node of the set.
struct NodalLoad {
  DeckName name;
  bool is_moment = false;
  EntitySet set;
  DirectionChoice direction;
  ScaledFunction function;  ///< time [time] to load per node [force], of moments [force*length]
  MeshVariable variable;    ///< in place of the function; multiplied by its scale factor
  ActivePeriods periods;
};

/// BEGIN PRESSURE: a traction against the face normal, positive pushes into the face.
struct Pressure {
  /// Faces that are left out: none, those masked by the deck, those in contact.
  enum class Masking : std::uint8_t { off, on, contact };

  DeckName name;
  EntitySet set;
  ScaledFunction function;                    ///< time [time] to pressure [force/length^2]
  MeshVariable variable;                      ///< in place of the function; its object is FACE by default
  double velocity_damping_coefficient = 0.0;  ///< pressure per normal velocity [force*time/length^3]
  Masking masking = Masking::off;
  std::optional<std::string> force_output_name;  ///< nodal variable that takes the forces of this block
  ActivePeriods periods;
};

/// BEGIN TRACTION: force per area along a direction that does not turn with the face.
struct Traction {
  DeckName name;
  EntitySet set;
  DirectionChoice direction;
  ScaledFunction function;  ///< time [time] to traction [force/length^2]
  ActivePeriods periods;
};

/// BEGIN GRAVITY: acceleration = constant * scale factor * function(time) along the direction. Several blocks
/// add.
struct Gravity {
  DeckName name;
  EntitySet set;  ///< names nothing: every node
  DirectionChoice direction;
  ScaledFunction function;              ///< time [time] to factor [1]; absent: 1
  double gravitational_constant = 1.0;  ///< [length/time^2]
  ActivePeriods periods;
};

/// BEGIN VISCOUS DAMPING: a force of mass x coefficient x velocity against the motion of every node. Several
/// blocks add.
struct ViscousDamping {
  DeckName name;
  EntitySet set;
  double mass_damping_coefficient = 0.0;  ///< >= 0 [1/time]
  ActivePeriods periods;
};

}  // namespace contactsim
