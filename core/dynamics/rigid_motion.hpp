// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/energy_balance.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"

/// Rigid bodies in the steps of the integrator. Between steps a body takes the forces of its nodes; the nodes
/// get accelerations that take them where the body goes, so that the nodes' own step moves them.
namespace contactsim {

/// Gives the nodes of a body its velocities of now.
void set_node_velocities(const RigidBody& body, const RigidBodyState& moving, State& state);

/// Puts bodies where the mesh has them unless the state has them elsewhere, gives them the momentum that
/// their nodes have together, and the nodes the velocities of their body.
void start_rigid_bodies(const Model& model, State& state);

/// Moves the bodies to the end of the step state.dt, and their nodes exactly to where they belong.
void move_rigid_bodies(const Model& model, State& state);

/// Sums the forces on the bodies, finds how they move in the coming step state.next_dt under the conditions
/// on them, and sets the accelerations of their nodes. At the start conditions give velocities, too.
void drive_rigid_bodies(const Model& model, State& state);

/// Adds the bodies' energies, momentum and the work of what drives them. The nodes themselves must not have
/// been counted but for the work of the forces on them.
void add_rigid_balance(const Model& model, const State& state, EnergyBalance& balance);

}  // namespace contactsim
