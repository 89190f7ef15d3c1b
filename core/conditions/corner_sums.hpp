// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/conditions/face_forces.hpp"
#include "core/mesh/indices.hpp"

namespace contactsim {

/// Adds forces at the corners of faces up to those of nodes, each node's in the order of its faces: the same
/// bits for any number of threads.
class CornerSums {
 public:
  CornerSums() = default;
  /// faces  [n_faces] nodes of the corners; a triangle repeats its last
  explicit CornerSums(std::span<const std::array<NodeIndex, 4>> faces);

  /// The nodes that faces have, ascending.
  std::span<const NodeIndex> nodes() const { return nodes_; }

  /// Adds to the forces of the nodes.
  ///   corner_forces  [n_faces] [force]
  ///   forces         [3 x n_nodes] [force]
  void add(std::span<const Corners> corner_forces, Eigen::Matrix3Xd& forces) const;

 private:
  std::vector<NodeIndex> nodes_;
  std::vector<std::uint32_t> begin_;   ///< [nodes_.size() + 1] first entry of each in places_
  std::vector<std::uint32_t> places_;  ///< 4 x face + corner
};

}  // namespace contactsim
