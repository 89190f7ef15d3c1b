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

/// The same of corners that are nodes of the mesh.
inline Eigen::Vector3d area_vector(const Eigen::Matrix3Xd& x, const std::array<NodeIndex, 4>& corners) {
  return area_vector(x.col(corners[0].value), x.col(corners[1].value), x.col(corners[2].value),
                     x.col(corners[3].value));
}

/// The same of a face of the mesh, summed over its facets. Precondition: the side is a face.
inline Eigen::Vector3d area_vector(const Mesh& mesh, ElementSide side) {
  const SideFacets facets = mesh.side_facets(side);
  Eigen::Vector3d area = area_vector(mesh.coordinates(), facets.corners[0]);
  for (std::size_t i = 1; i < facets.n; ++i) area += area_vector(mesh.coordinates(), facets.corners[i]);
  return area;
}

/// Area of a face of the mesh, that of its facets together [length^2]. Precondition: the side is a face.
inline double face_area(const Mesh& mesh, ElementSide side) {
  double area = 0.0;
  for (const auto& facet : mesh.side_facets(side)) area += area_vector(mesh.coordinates(), facet).norm();
  return area;
}

}  // namespace contactsim
