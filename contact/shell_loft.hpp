// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What the shells of a loft share with one another: nodes, for common normals, and edges.
class ShellNeighbours {
 public:
  /// `shells` ascending; all of family shell.
  ShellNeighbours(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates,
                  std::span<const ElementIndex> shells);

  /// Unit normal at a corner of a shell: mean of the shells around the node that lie within 60 degrees of
  /// this one, each weighted by its area and turned to this one's side. Where more than 256 shells meet in a
  /// node, the normal of this one alone. Zero for a shell without area.
  ///   shell  position in `shells`
  Eigen::Vector3d corner_normal(std::uint32_t shell, int corner) const;

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

  const Mesh& mesh_;
  std::span<const ElementIndex> shells_;
  std::vector<Eigen::Vector3d> area_vectors_;                        ///< [n_shells] [length^2]
  std::vector<std::pair<NodeIndex, std::uint32_t>> shells_of_node_;  ///< sorted by node, then shell
  std::vector<Edge> edges_;                                          ///< sorted
};

}  // namespace contactsim
