// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstring>

#include "contact/geometry/face_map.hpp"
#include "contact/geometry/float_lanes.hpp"

namespace contactsim {

/// Where a face is, roughly: enough to see that most candidates do not touch. All but its place has single
/// precision, and vectors stand so that products with one vector are made together.
class FaceBound {
 public:
  FaceBound() = default;
  /// Bounds a face; of a triangle the last corner is repeated.
  ///   v       of the corners [length/time]
  ///   height  of a surface that the face stands for over it, at most, either way [length]
  ///   lean    tangent of the angle between the normals of both, at most [1]
  FaceBound(const FaceCorners& x, const FaceCorners& v, bool is_triangle, float height = 0.0f,
            float lean = 0.0f);

  const Eigen::Vector3d& centre() const { return centre_; }  ///< mean of the corners [length]
  float radius() const { return radius_; }                   ///< of the sphere around the centre [length]
  Eigen::Vector3f normal() const { return vector(2); }       ///< unit, out of the element [1]
  Eigen::Vector3f velocity() const { return vector(3); }     ///< mean of the corners [length/time]
  /// How much faster than their mean a corner moves along the normal, at most [length/time].
  float normal_velocity_spread() const { return normal_velocity_spread_; }
  /// The face lies within warp() of the parallelogram centre +- half(0) +- half(1) [length].
  Eigen::Vector3f half(std::size_t i) const { return vector(i); }
  float warp() const { return warp_; }
  float lean() const { return lean_; }

  /// The products of a vector with half(0), half(1), normal and velocity.
  FourFloats times(const Eigen::Vector3f& w) const { return row(0) * w[0] + row(1) * w[1] + row(2) * w[2]; }
  /// Height of a point over the face's middle [length].
  float height_of(const Eigen::Vector3d& point) const {
    return (point - centre_).cast<float>().dot(normal());
  }
  /// Whether a point is on the side that the face looks to.
  bool is_in_front(const Eigen::Vector3d& point) const { return height_of(point) > 0.0f; }

 private:
  FourFloats row(std::size_t axis) const {
    FourFloats four;
    std::memcpy(&four, rows_[axis].data(), sizeof four);
    return four;
  }
  Eigen::Vector3f vector(std::size_t i) const { return {rows_[0][i], rows_[1][i], rows_[2][i]}; }
  void set(std::size_t i, const Eigen::Vector3f& vector) {
    for (std::size_t axis = 0; axis < 3; ++axis) rows_[axis][i] = vector[static_cast<Eigen::Index>(axis)];
  }

  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  std::array<std::array<float, 4>, 3> rows_{};  // components of halves, normal, velocity
  float warp_ = 0.0f, radius_ = 0.0f, normal_velocity_spread_ = 0.0f, lean_ = 0.0f;
};

/// By how much a unit normal may change while the corners move by so much, at most [1].
///   motion  [length]
float largest_turn(const FaceBound& face, bool is_triangle, double motion);

/// Whether two faces may touch: they face each other, are not farther apart along the normal than the
/// activation distance, and no direction along one of their edges parts them. Says yes rather too often.
///   activation_distance  gaps up to it count [length]
bool may_touch(const FaceBound& a, const FaceBound& b, double activation_distance);

/// Whether a point may project inside a face: within its edges or a bit beyond, from `depth` behind it to
/// `activation_distance` before it. Says yes rather too often.
///   beyond  how far beyond the edges counts [length]
bool may_project_inside(const Eigen::Vector3d& point, const FaceBound& face, double activation_distance,
                        double depth, double beyond);

}  // namespace contactsim
