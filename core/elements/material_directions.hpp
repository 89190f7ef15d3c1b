// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/elements/coordinate_system.hpp"
#include "core/elements/model_block.hpp"

namespace contactsim {

/// A turn of a coordinate system about one of its axes.
struct AxisRotation {
  std::int64_t axis = 1;  ///< 1, 2 or 3
  double angle = 0.0;     ///< [degrees]
};

/// Where the directions of a block's material point at rest.
struct MaterialDirections {
  CoordinateSystem system;
  AxisRotation first_rotation, second_rotation;  ///< about the system's axes, then about the turned ones

  /// Columns: the directions 1, 2, 3 at a place.
  Eigen::Matrix3d at(const Eigen::Vector3d& place) const;
};

/// Sets ModelBlock::directions, of every element at the mean of its nodes. Of shells, direction 1 is laid
/// into the surface, the others follow. Returns the place in the block of the first shell of which direction
/// 1 is the normal, when there is one.
std::optional<std::size_t> set_directions(const MaterialDirections& choice, const Mesh& mesh,
                                          ModelBlock& block);

}  // namespace contactsim
