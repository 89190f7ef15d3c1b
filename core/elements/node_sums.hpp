// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/lanes.hpp"
#include "core/mesh/indices.hpp"

namespace contactsim {

/// Adds the forces of elements up to those of nodes, each node's in the order of its elements: the same bits
/// for any number of threads.
class NodeSums {
 public:
  NodeSums() = default;
  /// Elements stand in batches of n_lanes, the last of which may be short.
  ///   connectivity       [n_elements x nodes_per_element], element by element
  ///   nodes_per_element  of all elements
  /// Precondition: fewer than 2^32 nodes of elements.
  NodeSums(std::span<const NodeIndex> connectivity, std::size_t nodes_per_element, std::size_t n_nodes);

  /// Adds to the forces of the nodes that have elements.
  ///   batch_forces  [n_batches x nodes_per_element x 3] of eight elements each
  ///   forces        [3 x n_nodes] [force]
  void add(std::span<const Lanes> batch_forces, Eigen::Matrix3Xd& forces) const;

 private:
  std::vector<std::uint32_t> nodes_;   ///< that have elements, ascending
  std::vector<std::uint32_t> begin_;   ///< [nodes_.size() + 1] first entry of each in places_
  std::vector<std::uint32_t> places_;  ///< (batch x nodes_per_element + node) x n_lanes + lane
};

}  // namespace contactsim
