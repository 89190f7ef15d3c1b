// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/common_plane.hpp"

namespace contactsim {

/// A face as it moves.
struct MovingFace {
  FaceCorners x;  ///< [length]
  FaceCorners v;  ///< [length/time]
  bool is_triangle = false;
  double sharpness = 0.0;  ///< see FaceOrientation [degrees]

  FaceOrientation look() const { return {area_vector(x), sharpness}; }
  /// Unit, out of the element [1].
  Eigen::Vector3d normal() const { return area_vector(x).normalized(); }
  /// The velocity of a point of the face by the weights of the corners there [length/time].
  Eigen::Vector3d velocity_at(const Eigen::Vector4d& weights) const { return v * weights; }
};

}  // namespace contactsim
