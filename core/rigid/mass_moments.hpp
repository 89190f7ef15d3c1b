// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/elements/model_block.hpp"

namespace contactsim {

/// Mass and its moments about the origin of some axes.
struct MassMoments {
  double mass = 0.0;                                 ///< [mass]
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< integral of x [mass length]
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< integral of x x^T [mass length^2]

  void add(double point_mass, const Eigen::Vector3d& at);
};

/// The moment of inertia that a second moment stands for: trace minus itself [mass length^2].
Eigen::Matrix3d inertia_of(const Eigen::Matrix3d& second_moment);

/// Moments of the elements of a block as the mesh has them, about an origin: solids by the tetrahedra under
/// their faces, shells by triangles of their thickness, whatever else by equal masses at its nodes. Faces of
/// four corners are split both ways, each for half.
///   origin  [length]
MassMoments mass_moments(const ModelBlock& block, const Mesh& mesh, const Eigen::Vector3d& origin);

}  // namespace contactsim
