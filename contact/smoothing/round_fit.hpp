// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "contact/smoothing/surface_shapes.hpp"

namespace contactsim {

/// A part of a surface that has no sharp edge inside: its nodes and its faces.
struct SurfacePart {
  std::vector<Eigen::Vector3d> nodes;    ///< each once [length]
  std::vector<Eigen::Vector3d> centres;  ///< [n_faces] means of the corners [length]
  std::vector<Eigen::Vector3d> areas;    ///< [n_faces] vectors out of the element [length^2]
};

/// What a part of a surface is.
struct PartFit {
  bool is_flat = false;
  std::optional<FittedShape> shape;  ///< when it is round
  double least_residual = 0.0;       ///< of all shapes that were tried, over the radius [1]
};

/// The largest residual of a shape that counts as round, over its radius.
inline constexpr double largest_residual = 1e-3;

/// Whether a part is a cylinder, else a sphere, else a torus: the first whose distances from the axis, the
/// centre or the circle differ by largest_residual at most. Parts with fewer than four normals are none: a
/// cylinder goes through any three of its lines; one whose normals all lean alike on an axis is no sphere.
/// Source: Pottmann, Wallner, Computational Line Geometry (2001), 4.1, for the axis that all normals of a
/// surface of revolution meet; Gauss and Newton for the least squares of the residuals.
PartFit fit_part(const SurfacePart& part);

}  // namespace contactsim
