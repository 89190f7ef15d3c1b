// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dynamics/time_step.hpp"
#include "core/elements/model_block.hpp"
#include "core/rigid/rigid_body.hpp"

namespace contactsim {

class StateArchive;

/// The forces on the nodes, each as it acts on them: mass x acceleration = internal + external + contact
/// + reaction [3 x n_nodes] [force].
struct NodalForces {
  Eigen::Matrix3Xd internal;
  Eigen::Matrix3Xd external;  ///< 3 x 0 of a run without loads
  Eigen::Matrix3Xd contact;   ///< 3 x 0 without contact

  Eigen::Vector3d external_at(Eigen::Index node) const { return column_of(external, node); }
  Eigen::Vector3d contact_at(Eigen::Index node) const { return column_of(contact, node); }
  /// The sum of all three.
  Eigen::Vector3d at(Eigen::Index node) const {
    return internal.col(node) + external_at(node) + contact_at(node);
  }

 private:
  static Eigen::Vector3d column_of(const Eigen::Matrix3Xd& forces, Eigen::Index node) {
    if (forces.cols() == 0) return Eigen::Vector3d::Zero();
    return forces.col(node);
  }
};

/// How the nodes turn. The arrays have no columns when no element has nodes that turn.
struct NodalRotations {
  Eigen::Matrix3Xd angle;         ///< [3 x n_nodes] angular velocity summed over time [1]
  Eigen::Matrix3Xd velocity;      ///< [3 x n_nodes] [1/time]
  Eigen::Matrix3Xd acceleration;  ///< [3 x n_nodes] [1/time^2]
  NodalForces moments;            ///< on the nodes [force length]

  bool exist() const { return velocity.cols() > 0; }
};

/// Energies since the start.
struct Energies {
  double kinetic = 0.0;  ///< now [energy]
  /// Work of all internal forces, the two below included, less what `unseen` has grown by since the start:
  /// with `kinetic`, the energy that central differences conserve [energy].
  double internal = 0.0;
  double hourglass = 0.0;        ///< part of internal [energy]
  double bulk_viscosity = 0.0;   ///< part of internal [energy]
  double external = 0.0;         ///< work of loads, gravity and prescribed motion [energy]
  double contact = 0.0;          ///< taken up by contact forces, the four below included [energy]
  double friction = 0.0;         ///< part of contact, lost for good [energy]
  double contact_damping = 0.0;  ///< part of contact, lost for good [energy]
  double impact = 0.0;           ///< part of contact, lost where sides met without rebound [energy]
  double stabilization = 0.0;    ///< part of contact, lost to contact stabilization of load steps [energy]
  /// What appeared from nowhere: kinetic + internal + contact - external less its value at the start. The
  /// kinetic energy here is the product of the velocities half a step before and behind, for which central
  /// differences conserve the sum to round-off, so that only real errors show [energy].
  double error = 0.0;
  /// mass x acceleration^2 x (half step before) x (half step behind) / 2, where internal forces act: by so
  /// much `kinetic` exceeds the product above. It comes and goes with every vibration, as what the strain
  /// energy has too much. Source: Krieg and Key, in: Numerical and Computer Methods in Structural Mechanics,
  /// Academic Press (1973) 237-258 [energy].
  double unseen = 0.0;
  double start =
      0.0;  ///< what the error is 0 with: kinetic energy at the start, what was taken over [energy]
  double largest = 0.0;  ///< of the terms so far, to compare the error with [energy]
};

/// Work of the forces over half a step [energy].
struct HalfStepWork {
  double internal = 0.0, external = 0.0, contact = 0.0;
};

/// An element whose stress fades.
struct DyingElement {
  ElementIndex element;
  std::int64_t n_steps = 1;  ///< over which it does
  std::int64_t n_left = 1;   ///< of them
};

/// What element death knows besides ModelBlockState::life.
struct DeathState {
  std::vector<DyingElement> dying;  ///< in the order in which they began
  std::vector<double> checked;      ///< [n_deaths] when the criteria of each were looked at last [time]
};

/// What nodes of subcycled elements have besides, as Subcycles::nodes; arrays without columns where nothing
/// is subcycled.
struct SubcycledNodes {
  Eigen::Matrix3Xd forces;   ///< [3 x n] of subcycled elements now, part of NodalForces::internal [force]
  Eigen::Matrix3Xd moments;  ///< [3 x n] the same, of nodes that turn [force length]
  Eigen::Matrix3Xd acceleration;          ///< [3 x n] by all other forces, constrained [length/time^2]
  Eigen::Matrix3Xd angular_acceleration;  ///< [3 x n] the same, of nodes that turn [1/time^2]
  HeldStableStep stable_step;             ///< of the subcycled elements
  double first_dt = 0.0;                  ///< of the first part of a step [time]
  std::int64_t n_parts = 0;               ///< that steps had so far

  bool exist() const { return forces.cols() > 0; }
};

/// All that a step changes. Between steps every member belongs to `time`.
struct State {
  std::int64_t step = 0;
  double time = 0.0;              ///< [time]
  double dt = 0.0;                ///< of the step that ended here, 0 before the first [time]
  double next_dt = 0.0;           ///< of the step that begins here [time]
  double first_dt = 0.0;          ///< of the first step [time]
  HeldStableStep stable_step;     ///< by the steps so far
  Eigen::Matrix3Xd coordinates;   ///< [3 x n_nodes] [length]
  Eigen::Matrix3Xd velocity;      ///< [3 x n_nodes] [length/time]
  Eigen::Matrix3Xd acceleration;  ///< [3 x n_nodes] [length/time^2]
  NodalForces forces;
  NodalRotations rotations;
  std::vector<RigidBodyState> rigid;  ///< as RigidBodies::bodies
  Energies energies;
  HalfStepWork begun;  ///< of the half step that begins here: the forces of now along the velocity to come
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< [mass length/time]
  std::vector<ModelBlockState> blocks;                 ///< as Model::blocks
  SubcycledNodes subcycled;
  DeathState death;
};

/// The state of a mesh: nothing is known yet of forces, energies and step sizes.
///   blocks     of the model
///   velocity   [3 x n_nodes], or 3 x 0: at rest [length/time]
///   has_loads  else external forces are 0 and take no memory
State make_state(const Eigen::Matrix3Xd& coordinates, std::span<const ModelBlock> blocks, double time,
                 Eigen::Matrix3Xd velocity = Eigen::Matrix3Xd(3, 0), bool has_loads = true);

/// Saves a state between two steps, or restores it; what every step works out anew is left out.
///   state  when it is restored, that of the start of the same model
void archive(State& state, StateArchive& saved);

}  // namespace contactsim
