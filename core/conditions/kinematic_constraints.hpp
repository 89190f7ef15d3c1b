// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/indices.hpp"
#include "core/conditions/condition_scope.hpp"
#include "core/conditions/free_directions.hpp"
#include "core/conditions/prescribed_motion.hpp"

namespace contactsim {

/// The nodes whose motion conditions constrain. Conditions act through the acceleration alone: it is set such
/// that the coming half step,
///   v(middle of the step after) = v(middle of the step before) + (dt_before + dt_after) / 2 * acceleration,
/// has the velocity that the condition wants. A condition acts in the steps that begin in its active periods.
class KinematicConstraints {
 public:
  /// Nothing is constrained.
  KinematicConstraints() = default;
  /// mesh    must outlive this
  /// motions  no two of them move one node in one direction at one time, unless both fix it
  KinematicConstraints(const Mesh& mesh, std::vector<PrescribedMotion> motions);

  /// The nodes that any condition may act on, ascending, each once.
  std::span<const NodeIndex> nodes() const { return nodes_; }

  /// Those that are fixed or prescribed along all three axes all the time, ascending.
  std::vector<NodeIndex> never_free() const;

  /// Which conditions act in the step that begins now [n_conditions].
  std::vector<std::uint8_t> find_active(double time) const;

  /// The directions that the conditions which act in the step that begins now leave free, of all nodes().
  /// They change only with find_active().
  std::vector<FreeDirections> find_free_directions(double time) const;

  /// Overwrites the accelerations of what is fixed or prescribed now. Throws SolveError when a condition has
  /// no finite value.
  ///   acceleration  [3 x n_nodes] of free motion [length/time^2]
  void constrain(const BetweenSteps& now, Eigen::Matrix3Xd& acceleration) const;

  /// Overwrites the velocities at the start of what is fixed or prescribed then, so that no node starts with
  /// a jump. Throws SolveError when a condition has no finite value.
  ///   start     dt_after is the first step, or what it is thought to be; the velocity is not looked at
  ///   velocity  [3 x n_nodes] that the initial conditions gave [length/time]
  void constrain_velocity(const BetweenSteps& start, Eigen::Matrix3Xd& velocity) const;

 private:
  const Mesh* mesh_ = nullptr;
  std::vector<PrescribedMotion> motions_;
  std::vector<NodeIndex> nodes_;
};

/// Compiles the kinematic conditions of a region on where nodes are. Errors: unknown names, two conditions
/// that drive one node in one direction at one time. Holding a node twice is no error. Nodes of
/// rigid bodies are left out, with a warning when not all nodes of the body are named. Throws FileError when
/// the mesh file cannot be read.
KinematicConstraints make_kinematic_constraints(const ConditionScope& scope);

/// Compiles those on the places and on the rotations of rigid bodies, whose nodes the two functions around
/// these leave out: a condition acts on the bodies of which it names all nodes, at their centres. Its nodes
/// are the bodies. Errors: as make_kinematic_constraints, and values that are read from the mesh. Nothing
/// without rigid bodies in the scope.
KinematicConstraints make_body_constraints(const ConditionScope& scope);
KinematicConstraints make_body_rotation_constraints(const ConditionScope& scope);

/// Compiles those on how nodes turn; an axis counts as its direction. Nodes without rotations, those of
/// solids alone, are left out. Errors: as make_kinematic_constraints, and prescribed rotations that are left
/// without nodes; such fixed rotations are ignored with a warning. Throws FileError.
///   inertia  [n_nodes] lumped, minimum_nodal_mass where nothing turns; empty when no node turns
///            [mass length^2]
KinematicConstraints make_rotation_constraints(const ConditionScope& scope,
                                               const Eigen::RowVectorXd& inertia);

}  // namespace contactsim
