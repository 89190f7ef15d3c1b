// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

class RankShare;

/// Sums over the nodes at the end of a step.
struct EnergyBalance {
  double kinetic = 0.0;      ///< of the velocities now [energy]
  double conserved = 0.0;    ///< of the velocities half a step before times those half a step behind [energy]
  double unseen = 0.0;       ///< as Energies::unseen [energy]
  HalfStepWork ended;        ///< of the half step that ends now, along its velocity
  HalfStepWork begun;        ///< of the half step that begins now, along its velocity
  Eigen::Vector3d momentum;  ///< [mass length/time]
};

/// Brings the velocities from the middle of the step that ends (at the start: from now) to now, and sums work
/// and energy over the nodes in a fixed order. Forces and accelerations are those of now; what
/// mass x acceleration has beyond the forces is the reaction, whose work counts as external. Of the nodes of
/// rigid bodies only the work of the forces counts.
///   share  of a rank: it brings the nodes that it follows to now; null: all
EnergyBalance complete_velocities(const Model& model, State& state, RankShare* share = nullptr);

/// The moment by which conditions hold or turn a node: inertia x angular acceleration less all other moments.
/// Precondition: the state has rotations [force length].
Eigen::Vector3d reaction_moment_at(const Model& model, const State& state, NodeIndex node);

/// The force by which conditions hold or drive a node: mass x acceleration less all other forces [force].
Eigen::Vector3d reaction_at(const Model& model, const State& state, NodeIndex node);

}  // namespace contactsim
