// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/base/indices.hpp"

namespace contactsim {

/// A rigid body at rest. Const after set-up.
struct RigidBody {
  std::string name;
  std::vector<NodeIndex> nodes;                      ///< that move with it, ascending
  Eigen::Matrix3Xd arms;                             ///< [3 x nodes] from the centre of mass to each [length]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of mass, at rest [length]
  double mass = 0.0;                                 ///< > 0 [mass]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< about the centre [mass length^2]
  Eigen::Matrix3d flexible = Eigen::Matrix3d::Zero();  ///< inverse of inertia; 0 about axes without any
};

/// A body between steps. Vectors are along the global axes. `before` and `after` belong to the middles of the
/// steps that end and begin now.
struct RigidBodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the centre [length]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d angle = Eigen::Vector3d::Zero();  ///< angular velocity summed over time [1]

  /// Velocity, angular velocity and angular momentum about the centre.
  struct Motion {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [length/time]
    Eigen::Vector3d turning = Eigen::Vector3d::Zero();   ///< [1/time]
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();      ///< [mass length^2/time]
  };
  Motion before, now, after;
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();          ///< [length/time^2]
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();  ///< [1/time^2]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();            ///< on the nodes, all but the reaction [force]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();           ///< about the centre [force length]
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();         ///< what holds or drives it [force]
  Eigen::Vector3d reaction_moment = Eigen::Vector3d::Zero();  ///< [force length]
};

/// The inverse of a symmetric tensor without negative eigenvalues; 0 along directions in which it has none to
/// speak of.
Eigen::Matrix3d inverse_where_it_is(const Eigen::Matrix3d& symmetric);

/// The rotation by a vector: about its direction, by its length.
Eigen::Quaterniond turn_by(const Eigen::Vector3d& vector);

/// The moment of inertia in the middle of a step that begins with an orientation and turns steadily, along
/// the global axes [mass length^2].
Eigen::Matrix3d inertia_amid(const RigidBody& body, const Eigen::Quaterniond& orientation,
                             const Eigen::Vector3d& turning, double dt);

/// The steady turning in a step that has an angular momentum in its middle: exact for it, so that a free body
/// keeps its angular momentum to round-off. Source: Simo and Wong, Int. J. Numer. Meth. Eng. 31 (1991) 19-52;
/// Krysl, same 63 (2005) 2171-2193, explicit midpoint.
///   spin  [mass length^2/time]
Eigen::Vector3d turning_of(const RigidBody& body, const Eigen::Quaterniond& orientation,
                           const Eigen::Vector3d& spin, double dt);

/// The same when motion along some directions is given: turning = given + free part, of which only what is
/// free follows the momentum.
///   given  what is prescribed, at right angles to what is free [1/time]
///   free   projection on the directions that are free
Eigen::Vector3d turning_of(const RigidBody& body, const RigidBodyState& state, const Eigen::Vector3d& spin,
                           double dt, const Eigen::Vector3d& given, const Eigen::Matrix3d& free);

}  // namespace contactsim
