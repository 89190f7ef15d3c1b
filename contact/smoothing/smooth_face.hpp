// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "contact/geometry/face_face.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/smoothing/round_shape.hpp"

namespace contactsim {

/// How far a round surface rises over one of its faces: a property of the face's coordinates, found on the
/// mesh of the start. Corners keep their own radii r_i, so that they lie on the surface: at (xi, eta) it has
/// the radius sum of N_i r_i, the face that of its point.
class SmoothFace {
 public:
  /// Nothing for a face that does not go round the shape: one that looks along the axis, or stands on it.
  ///   corners  at the start [length]
  static std::optional<SmoothFace> make(const RoundShape& shape, const FaceCorners& corners,
                                        bool is_triangle);

  /// The way from the face to the round surface at a point, in the axes of the face [length].
  FaceVector rise_at(double xi, double eta) const;
  double height() const { return height_; }  ///< of the surface over the face, at most, either way [length]
  double lean() const { return lean_; }      ///< tangent of the angle between both's normals, at most [1]
  double area_ratio() const { return area_ratio_; }  ///< area of the surface over that of the face [1]
  double sharpness = 0.0;  ///< of its edges where the round surface ends, see FaceOrientation [degrees]

 private:
  void measure();

  RoundShape shape_;
  FaceMap start_;                 // in the coordinates of the mesh
  FaceFunction radius_;           // sum of N_i r_i
  Eigen::Matrix3d to_face_axes_;  // at the start
  double height_ = 0.0, lean_ = 0.0, area_ratio_ = 1.0;
};

/// A face as it is now with the surface that it stands for: a round one that has turned along with it, or the
/// face itself.
class SmoothPatch {
 public:
  ///   smooth  null: the face itself; must outlive this
  SmoothPatch(const MovingFace& face, const SmoothFace* smooth);

  /// A point of the surface.
  struct Point {
    Eigen::Vector3d on_face;              ///< that the surface rises over [length]
    Eigen::Vector3d x;                    ///< [length]
    Eigen::Vector3d along_xi, along_eta;  ///< tangents of the surface [length]
    /// Unit, out of the element [1].
    Eigen::Vector3d normal() const { return along_xi.cross(along_eta).normalized(); }
  };
  Point at(double xi, double eta) const;
  Eigen::Vector3d velocity_at(double xi, double eta) const { return velocity_.at(xi, eta); }

  const MovingFace& face() const { return face_; }
  bool is_triangle() const { return map_.is_triangle; }
  double sharpness() const { return smooth_ != nullptr ? smooth_->sharpness : face_.sharpness; }
  double height() const { return smooth_ != nullptr ? smooth_->height() : 0.0; }

 private:
  const MovingFace& face_;
  const SmoothFace* smooth_;
  FaceMap map_, velocity_;
  Eigen::Matrix3d axes_;
};

/// Projects a sphere onto a surface along its normal, as project_sphere() does onto the face: the closest
/// point is that of the face below, so that a force along the normal that the corners share by its
/// coordinates has no moment. Beyond the edges of the face a sphere meets the face itself.
///   radius  >= 0 [length]
std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle, const SmoothFace* smooth,
                                           const Eigen::Vector3d& centre, double radius);

}  // namespace contactsim
