// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace contactsim {

/// A vector as a function of a face's coordinates, with its derivatives.
struct FaceVector {
  Eigen::Vector3d value, by_xi, by_eta;
};

/// The line, point or circle that a round surface lies around at a distance.
struct RoundShape {
  enum class Kind : std::uint8_t {
    circumferential,  ///< about an axis
    spherical,        ///< about a point
    toroidal          ///< about a circle around an axis
  };

  Kind kind = Kind::circumferential;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the axis, the sphere or the circle [length]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< unit; of a sphere any [1]
  double arc_radius = 0.0;                           ///< of the circle of a torus [length]

  /// The way from the nearest point of the line, point or circle to a point: its length is the point's radius
  /// [length].
  Eigen::Vector3d way_to(const Eigen::Vector3d& x) const;
  /// The same along a face.
  FaceVector way_to(const FaceVector& x) const;
  double radius_of(const Eigen::Vector3d& x) const { return way_to(x).norm(); }
};

}  // namespace contactsim
