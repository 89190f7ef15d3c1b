// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/conditions/condition_scope.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

/// Makes the rigid bodies that blocks of the model belong to, in deck order, and scales the masses of their
/// nodes where the deck gives a mass. Mass and centre are those of the nodes, which includes what neighbours
/// that are not rigid give them; the inertia is that of the elements. A given inertia is about the centre, or
/// about the reference location. Errors: nodes of two bodies, a reference location off the centre unless mass
/// and inertia are given with it, unknown node sets, bodies without mass.
void make_rigid_bodies(const SimulationDefinition& definition, const Region& region, Model& model,
                       Diagnostics& diagnostics);

/// Gives the nodes of bodies the initial velocities that the deck's RIGID BODY blocks give, in place of
/// others. Errors: a size without a direction or axis.
///   velocity  [3 x n_nodes] [length/time]
void set_rigid_velocities(const ConditionScope& scope, const RigidBodies& rigid, Eigen::Matrix3Xd& velocity);

}  // namespace contactsim
