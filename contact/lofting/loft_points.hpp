// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/lofting/loft.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// The points of the skins of lofted shells, each once, and how they stand off the nodes by the shells'
/// normals. Which shells give a point its normal stays as it was at the start: no point jumps when shells
/// fold.
class LoftPoints {
 public:
  LoftPoints() = default;
  /// Makes one point of all vertices that hang on the same node, at the same height, by the same shells.
  LoftPoints(const LoftGeometry& loft, const Mesh& mesh);

  std::size_t size() const { return offsets_.size(); }
  /// The point of a vertex of a brick; nothing for one that no shell offsets.
  OptionalIndex<std::uint32_t> of_vertex(std::uint32_t vertex) const { return point_of_vertex_[vertex]; }
  /// The node of the mesh that a point hangs on, its distance from it and the shell's thickness [length].
  NodeIndex node(std::size_t point) const { return nodes_[point]; }
  double distance(std::size_t point) const { return std::abs(offsets_[point].height); }
  double thickness(std::size_t point) const { return offsets_[point].thickness; }
  /// The nodes of the mesh of each shell; a triangle repeats its last.
  std::span<const std::array<NodeIndex, 4>> shell_nodes() const { return shell_nodes_; }

  /// The way from the node to each point.
  ///   coordinates  3 x n_nodes of the mesh [length]
  ///   areas        3 x n_shells, scratch
  ///   arms         3 x size() [length]
  void find_offsets(const Eigen::Matrix3Xd& coordinates, Eigen::Matrix3Xd& areas,
                    Eigen::Matrix3Xd& offsets) const;

 private:
  std::vector<OptionalIndex<std::uint32_t>> point_of_vertex_;  // [n_vertices]
  std::vector<NodeIndex> nodes_;                               // [n_points]
  std::vector<LoftOffset> offsets_;                            // [n_points]
  std::vector<TurnedShell> offset_shells_;                     // of the arms
  std::vector<std::array<NodeIndex, 4>> shell_nodes_;          // [n_shells]; a triangle repeats its last
};

}  // namespace contactsim
