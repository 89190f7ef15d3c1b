// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "core/conditions/active_times.hpp"
#include "core/conditions/condition_function.hpp"
#include "core/conditions/direction.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A time between two steps, as kinematic conditions see it.
struct BetweenSteps {
  double time;                          ///< now [time]
  double dt_before;                     ///< of the step that ends now; 0 at the start [time]
  double dt_after;                      ///< of the step that begins now, > 0 [time]
  const Eigen::Matrix3Xd& coordinates;  ///< [3 x n_nodes] now [length]
  /// [3 x n_nodes] at the middle of the step before; at the start, now [length/time].
  const Eigen::Matrix3Xd& velocity;
  /// [3 x n_nodes] when rotations are prescribed: how far nodes have turned; the velocity is then angular [1]
  const Eigen::Matrix3Xd* angle = nullptr;

  /// From the mesh to now [length], or how far the node has turned [1].
  double displacement(const Eigen::Matrix3Xd& model_coordinates, Eigen::Index component,
                      Eigen::Index node) const {
    if (angle != nullptr) return (*angle)(component, node);
    return coordinates(component, node) - model_coordinates(component, node);
  }
  Eigen::Vector3d displacement(const Eigen::Matrix3Xd& model_coordinates, Eigen::Index node) const {
    if (angle != nullptr) return angle->col(node);
    return coordinates.col(node) - model_coordinates.col(node);
  }
};

/// What a kinematic condition does to its nodes.
enum class MotionType : std::uint8_t {
  fixed,         ///< keeps them where they are
  displacement,  ///< moves them to the mesh's position plus a value, about an axis turned by an angle
  velocity,      ///< about an axis: angular velocity
  acceleration   ///< about an axis: angular acceleration
};

/// One kinematic condition, looked up and compiled. Along components or a unit vector the other directions
/// stay free. About an axis nodes move on arcs: their distance from the axis is kept, motion along it is
/// free.
struct PrescribedMotion {
  MotionType type = MotionType::fixed;
  Direction direction;
  /// [length], [length/time], [length/time^2]; about an axis radians for the length.
  ConditionFunction value{0.0};
  ActiveTimes times;
  std::vector<NodeIndex> nodes;  ///< ascending, each once
  ConditionLabel label;
  /// Of rigid bodies, which its nodes are the positions of, the names of all [n_bodies]; empty: nodes of the
  /// mesh
  std::vector<std::string> bodies = {};

  /// Overwrites the prescribed parts of accelerations, such that the coming half step has the wanted
  /// velocity. Throws SolveError when the value is not finite.
  void set_acceleration(const BetweenSteps& now, const Mesh& mesh, Eigen::Matrix3Xd& acceleration) const;

  /// Overwrites the prescribed parts of velocities at the start. Accelerations prescribe no part of them; of
  /// displacements it is the mean over the first step. Throws SolveError when the value is not finite.
  ///   now  its velocity is not looked at
  void set_velocity(const BetweenSteps& now, const Mesh& mesh, Eigen::Matrix3Xd& velocity) const;
};

}  // namespace contactsim
