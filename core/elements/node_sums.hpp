// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/indices.hpp"
#include "core/base/node_ranges.hpp"
#include "core/elements/node_vector.hpp"

namespace contactsim {

/// Adds forces that stand in several places, those of chunks of elements or of the corners of faces, up at
/// the nodes they belong to, each node's in the order of the places: the same bits for any number of threads.
class NodeSums {
 public:
  NodeSums() = default;
  ///   nodes    [n_places] of the mesh
  ///   n_nodes  of the mesh
  NodeSums(std::span<const std::uint32_t> nodes, std::size_t n_nodes);
  /// Of some of the places alone.
  ///   places  of nodes, ascending
  NodeSums(std::span<const std::uint32_t> nodes, std::size_t n_nodes, std::span<const std::uint32_t> places);

  /// The nodes that have places, ascending.
  std::vector<NodeIndex> nodes() const;

  /// Adds to the forces of the nodes that have places.
  ///   parts   [n_places] [force]
  ///   forces  [3 x n_nodes] [force]
  void add(std::span<const NodeVector> parts, Eigen::Matrix3Xd& forces) const;
  /// The same of those among some nodes.
  void add(std::span<const NodeVector> parts, const NodeRanges& nodes, Eigen::Matrix3Xd& forces) const;
  /// Sets the forces of those nodes, to the bits that adding to zeros gives.
  void set(std::span<const NodeVector> parts, const NodeRanges& nodes, Eigen::Matrix3Xd& forces) const;

 private:
  template <class Take>
  void visit(std::span<const NodeVector> parts, const NodeRanges& nodes, const Take& take) const;
  bool follow_each_other() const { return nodes_.empty(); }
  std::size_t size() const { return begin_.size() - 1; }
  NodeIndex node(std::size_t k) const {
    return follow_each_other() ? NodeIndex{first_node_ + static_cast<std::uint32_t>(k)} : nodes_[k];
  }

  /// The nodes, or none where each follows the one before, which is usual in a mesh of one block.
  std::vector<NodeIndex> nodes_;
  std::uint32_t first_node_ = 0;
  std::vector<std::uint32_t> begin_{0};  ///< [size() + 1] first entry of each in places_
  std::vector<std::uint32_t> places_;    ///< by node
};

}  // namespace contactsim
