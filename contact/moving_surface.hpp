// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "contact/contact_faces.hpp"
#include "contact/face_face.hpp"
#include "core/elements/gather.hpp"
#include "core/force_term.hpp"

namespace contactsim {

/// Where a face is, roughly: enough to see that most candidates do not touch.
struct FaceBound {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< mean of the corners [length]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< unit, out of the element [1]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< mean of the corners [length/time]
  double radius = 0.0;                                 ///< of the ball around the centre [length]
  /// The face lies within `twist` of the parallelogram centre +- half_1 +- half_2 [length].
  Eigen::Vector3d half_1 = Eigen::Vector3d::Zero(), half_2 = Eigen::Vector3d::Zero();
  double twist = 0.0;

  /// How far the face reaches from its centre along a direction, times the direction's length.
  double extent(const Eigen::Vector3d& direction) const {
    return std::abs(half_1.dot(direction)) + std::abs(half_2.dot(direction)) + twist * direction.norm();
  }
};

/// Whether two faces may touch: they look at each other, are not farther apart along the normal than the
/// reach, and no direction along one of their edges parts them. Says yes rather too often.
///   reach  gaps up to it count [length]
bool may_touch(const FaceBound& a, const FaceBound& b, double reach);

/// Whether a point may stand over a face: within its edges or a bit beyond, from `depth` behind it to `reach`
/// before it. Says yes rather too often.
///   beyond  how far beyond the edges counts [length]
bool may_stand_over(const Eigen::Vector3d& point, const FaceBound& face, double reach, double depth,
                    double beyond);

/// The contact nodes and faces at one moment.
class MovingSurface {
 public:
  /// The faces must outlive this.
  explicit MovingSurface(const ContactFaces& faces) : faces_(faces) {}

  /// Takes over the motion of the nodes. Bounds of faces are those of earlier then.
  void move_nodes(const Motion& motion);
  /// Brings the bounds of all faces, or of the watched ones, to where their nodes are.
  void bound_all();
  void bound_watched();
  /// The faces that may touch something for now.
  void watch(std::vector<std::uint32_t> faces) { watched_ = std::move(faces); }

  const ContactFaces& faces() const { return faces_; }
  Eigen::Vector3d x(std::uint32_t node) const { return x_[node].head<3>(); }
  Eigen::Vector3d v(std::uint32_t node) const { return v_[node].head<3>(); }
  const FaceBound& bound(std::uint32_t face) const { return bounds_[face]; }
  MovingFace face(std::uint32_t face) const;
  /// Share of a face's area vector that each of its corners has [length^2].
  Eigen::Vector3d corner_area(std::uint32_t face) const;
  /// How much of its surface a node has as seen against a normal: the sides of an edge do not count for what
  /// its top touches. At least a hundredth of its share of the area at the start, which is that of nodes
  /// without faces.
  ///   normal  unit, towards the node [1]
  double area_against(const SurfaceNode& node, const Eigen::Vector3d& normal) const;

 private:
  void set_bound(std::size_t face);

  const ContactFaces& faces_;
  std::vector<std::uint32_t> watched_;
  std::vector<NodeVector> x_, v_;  // [n_contact_nodes]
  std::vector<FaceBound> bounds_;  // [n_faces]
};

}  // namespace contactsim
