// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/geometry/cross_matrix.hpp"
#include "contact/lofting/loft_points.hpp"
#include "contact/mesh/free_directions.hpp"
#include "core/base/indexed_vector.hpp"
#include "core/base/indices.hpp"
#include "core/base/optional_index.hpp"
#include "core/rigid/rigid_nodes.hpp"

namespace contactsim {

/// How the mid surface of lofted shells turns about its nodes, by which the points of lofts go with it: the
/// spin that fits the velocities of a node's neighbours best,
///   W = (sum |r|^2 I - r r^T)^-1 sum r x (v_j - v_i),  r = x_j - x_i,
/// over the nodes of the shells around it. A moment about the node is given to its neighbours and to itself
/// as the forces that do the same work, F_j = (sum ...)^-1 m x r_j, which have no sum and the moment m: so
/// contact makes neither momentum nor energy.
///
/// The rotations of the nodes would do, too, but a squeeze on both sides of a shell pulls at its fibres with
/// F t theta, and one-point shells hardly resist where every other fibre turns the other way: the loft lies
/// down and lets both sides through.
class LoftSpins {
 public:
  LoftSpins() = default;
  /// Nodes of rigid bodies turn as those do, and are no neighbours. Nodes with fewer than two neighbours turn
  /// by themselves; those whose neighbours all lie on a line with them do not turn.
  LoftSpins(const LoftPoints& loft, std::size_t n_mesh_nodes, const RigidNodes& rigid);

  /// Takes over where the nodes are.
  ///   coordinates  [3 x n_nodes] of the mesh [length]
  void update(const Eigen::Matrix3Xd& coordinates);
  /// Takes over which rotations conditions hold or drive; about those a node turns by itself.
  void hold(const ModelFreeDirections& free);

  std::size_t size() const { return nodes_.size(); }
  /// The node of the mesh with a spin.
  NodeIndex node(std::size_t i) const { return nodes_[i]; }
  /// Position of a node of the mesh among those with a spin; nothing without one.
  OptionalIndex<std::uint32_t> find(NodeIndex mesh_node) const {
    return index_.empty() ? OptionalIndex<std::uint32_t>() : index_[mesh_node];
  }
  /// The nodes of the mesh around a node.
  std::span<const NodeIndex> neighbours(std::size_t i) const {
    return std::span(neighbours_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

  /// The spin.
  ///   own          angular velocity of the node by itself [1/time]
  ///   velocity     of the node [length/time]
  ///   velocity_of  of the neighbour at a position
  template <class VelocityOf>
  Eigen::Vector3d spin(std::size_t i, const Eigen::Vector3d& own, const Eigen::Vector3d& velocity,
                       const VelocityOf& velocity_of) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Eigen::Vector3d moves = velocity_of(k - first_[i]) - velocity;
      sum += arms_[k].cross(moves);
    }
    return own + free_[i] * (flexible_[i] * sum - own);
  }
  /// By what a neighbour's motion against the node turns it [1/length].
  Eigen::Matrix3d turn_by(std::size_t i, std::size_t neighbour) const {
    return free_[i] * flexible_[i] * cross_matrix(arms_[first_[i] + neighbour]);
  }
  /// What of its own rotation the node keeps [1].
  Eigen::Matrix3d own_turn(std::size_t i) const { return Eigen::Matrix3d::Identity() - free_[i]; }
  /// The spin in the middle of a step, by which the node turns through the angle 2 atan(dt |W| / 2).
  ///   coordinates, velocity  [3 x n_nodes] of the mesh at its end, in its middle [length] [length/time]
  Eigen::Vector3d mid_spin(std::size_t i, const Eigen::Matrix3Xd& coordinates,
                           const Eigen::Matrix3Xd& velocity, double dt, const Eigen::Vector3d& own) const;
  /// Gives a moment to the neighbours: calls give(position, force) for each of them. The node gets the
  /// opposite of their sum, which is returned.
  template <class Give>
  Eigen::Vector3d spread(std::size_t i, const Eigen::Vector3d& moment, const Give& give) const {
    const Eigen::Vector3d turn = flexible_[i] * (free_[i] * moment);
    Eigen::Vector3d rest = Eigen::Vector3d::Zero();
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Eigen::Vector3d force = turn.cross(arms_[k]);
      give(k - first_[i], force);
      rest -= force;
    }
    return rest;
  }
  /// Bounds of the forces that a moment of 1 gives to a neighbour and to the node [1/length].
  double bound(std::size_t i, std::size_t neighbour) const { return bounds_[first_[i] + neighbour]; }
  double own_bound(std::size_t i) const { return own_bounds_[i]; }
  /// What of a moment the node takes by itself.
  Eigen::Vector3d own_share(std::size_t i, const Eigen::Vector3d& moment) const {
    return moment - free_[i] * moment;
  }

 private:
  std::vector<NodeIndex> nodes_, neighbours_;
  std::vector<std::uint32_t> first_;
  IndexedVector<NodeIndex, OptionalIndex<std::uint32_t>> index_;
  std::vector<Eigen::Matrix3d> free_;        // [size()] projection on rotations that are free [1]
  std::vector<Eigen::Matrix3d> flexible_;    // [size()] (sum |r|^2 I - r r^T)^-1 [1/length^2]
  std::vector<double> own_bounds_, bounds_;  // [size()] [n_neighbours] see bound() [1/length]
  std::vector<Eigen::Vector3d> arms_;        // [n_neighbours] r [length]
};

}  // namespace contactsim
