// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Area of a face times its unit normal, out of the element: half the cross product of the diagonals. A
/// triangle repeats its last corner. For a warped quadrilateral it is the area projected along the mean
/// normal.
///   a, b, c, d  corners in right-hand order [length]; result [length^2]
inline Eigen::Vector3d area_vector(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                   const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  return 0.5 * (c - a).cross(d - b);
}

/// The same of corners in columns.
inline Eigen::Vector3d area_vector(const Eigen::Matrix<double, 3, 4>& corners) {
  return area_vector(corners.col(0), corners.col(1), corners.col(2), corners.col(3));
}

/// The same of a face of the mesh. Precondition: the side is a face.
inline Eigen::Vector3d area_vector(const Mesh& mesh, ElementSide side) {
  const std::array<NodeIndex, 4> nodes = mesh.side_nodes(side);
  const auto& x = mesh.coordinates();
  return area_vector(x.col(nodes[0].value), x.col(nodes[1].value), x.col(nodes[2].value),
                     x.col(nodes[3].value));
}

}  // namespace contactsim
