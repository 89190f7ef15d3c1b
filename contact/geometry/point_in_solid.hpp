// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/mesh/topology.hpp"

namespace contactsim {

/// Whether a solid holds a point, its walls included. Each face is cut into triangles about the mean of its
/// corners, and the element into the tetrahedra between these and the mean of its own, so that neighbours
/// with warped faces leave no gap between them. Nodes between corners do not count.
///   corners  [3 x n_corners, or more] of the element, in its order [length]
///   shape    of the solid family
bool is_in_solid(const Eigen::Ref<const Eigen::Matrix3Xd>& corners, const Topology& shape,
                 const Eigen::Vector3d& point);

}  // namespace contactsim
