// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A shell around a node, as another one there sees it.
struct TurnedShell {
  std::uint32_t shell = 0;  ///< position among the lofted shells
  bool is_turned = false;   ///< its normal is on the other side
  auto operator<=>(const TurnedShell&) const = default;
};

/// What the shells of a loft share with one another: nodes, for common normals, and edges.
class ShellNeighbours {
 public:
  /// `shells` ascending; all of family shell.
  ShellNeighbours(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates,
                  std::span<const ElementIndex> shells);

  /// The shells around the node of a corner that share their normal with this one: those within 60 degrees
  /// of it, seen from the same side of the sheet as edges around the node lead from one to the next: a sheet
  /// folded back on itself is not smooth. Ascending. Where more than 256 shells meet in a node, this one
  /// alone.
  ///   shell  position in `shells`
  std::vector<TurnedShell> around(std::uint32_t shell, int corner) const;

  /// Unit normal of shells that share it: their mean, each weighted by its area and turned to the side of the
  /// one that was asked for. Zero for shells without area.
  Eigen::Vector3d mean_normal(std::span<const TurnedShell> around) const;

  /// Whether no other shell has the edge from the corner to the next one. False for corners on one node.
  bool is_perimeter(std::uint32_t shell, int corner) const;

 private:
  /// An edge of a shell, whichever way it runs.
  struct Edge {
    NodeIndex low, high;
    std::uint32_t shell = 0;
    auto operator<=>(const Edge&) const = default;
  };

  std::span<const NodeIndex> corners(std::uint32_t shell) const;
  /// Whether the shells at a node are oriented as the one at a position among them: 1, or -1 if not; 0 of
  /// shells that no edges join to it there.
  std::vector<int> orientations(NodeIndex node, std::span<const std::pair<NodeIndex, std::uint32_t>> shells,
                                std::size_t own) const;

  const Mesh& mesh_;
  std::span<const ElementIndex> shells_;
  std::vector<Eigen::Vector3d> area_vectors_;                        ///< [n_shells] [length^2]
  std::vector<std::pair<NodeIndex, std::uint32_t>> shells_of_node_;  ///< sorted by node, then shell
  std::vector<Edge> edges_;                                          ///< sorted
};

}  // namespace contactsim
