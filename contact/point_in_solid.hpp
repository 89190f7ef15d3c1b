// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Whether a solid holds a point, its walls included. Each face is cut into triangles about the mean of its
/// corners, and the element into the tetrahedra between these and the mean of its own, so that neighbours
/// with warped faces leave no gap between them. Nodes between corners do not count.
///   coordinates  [3 x n_nodes] [length]
///   nodes        of one element
///   shape        of the solid family
bool is_in_solid(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes, const Topology& shape,
                 const Eigen::Vector3d& point);

}  // namespace contactsim
