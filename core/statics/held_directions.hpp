// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/optional_index.hpp"
#include "core/conditions/free_directions.hpp"
#include "core/statics/static_bodies.hpp"

namespace contactsim {

/// The directions along which nodes of load steps, those of rigid bodies among them, cannot move by
/// themselves: fixed or prescribed by conditions, and all of what has lost its elements.
class HeldDirections {
 public:
  ///   n      3 a node: where rotations begin in vectors of unknowns
  ///   turns  whether nodes turn
  HeldDirections(Eigen::Index n, bool turns) : n_(n), turns_(turns) {}

  /// Takes those that conditions hold at a time, and lifeless nodes.
  void find(const Model& model, const StaticBodies& bodies, double time);
  /// From the next find() or hold_lifeless() on nodes without living elements are these.
  ///   nodes  ascending
  void set_lifeless(std::vector<NodeIndex> nodes) { lifeless_ = std::move(nodes); }
  /// Has lifeless nodes stay where they are: nothing resists what loads them.
  void hold_lifeless();

  /// Takes out of a vector what lies along them.
  void project(Eigen::VectorXd& vector) const;
  /// Of displacements alone, a node each.
  const std::vector<FreeDirections>& displacements() const { return free_; }
  /// Calls take(node, first, held) for every node with any: held projects on them, of its displacements
  /// (first 0) or rotations (first 3).
  template <class Take>
  void visit(const Take& take) const {
    const auto visit_nodes = [&](const std::vector<FreeDirections>& nodes, Eigen::Index first) {
      for (const FreeDirections& free : nodes)
        take(free.node.value, first, Eigen::Matrix3d(Eigen::Matrix3d::Identity() - free.projection));
    };
    visit_nodes(free_, 0);
    visit_nodes(free_rotations_, 3);
  }

 private:
  Eigen::Index n_;
  bool turns_;
  std::vector<FreeDirections> free_, free_rotations_;
  std::vector<NodeIndex> lifeless_;
};

/// What held directions leave to the nodes that have any, looked up by node.
class FreeProjections {
 public:
  ///   n_nodes  those of rigid bodies included
  FreeProjections(const HeldDirections& held, std::size_t n_nodes);

  /// What a node's displacement, or rotation, is projected by; null where nothing is held.
  const Eigen::Matrix3d* find(std::uint32_t node, bool turns) const {
    const auto place = places_[2 * std::size_t{node} + (turns ? 1 : 0)];
    return place ? &projections_[*place] : nullptr;
  }

 private:
  std::vector<OptionalIndex<std::uint32_t>> places_;  // of displacements and rotations of each node
  std::vector<Eigen::Matrix3d> projections_;
};

}  // namespace contactsim
