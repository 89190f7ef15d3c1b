// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// The change of a face's weights by which its linear extension moves a point along it. With the position
/// x(xi, eta) of the bilinear face the way w = a dxi + b deta, where a = dx/dxi and b = dx/deta in the
/// middle: (dxi, deta) are the solution of the normal equations [a.a a.b; a.b b.b] (dxi, deta) = (a.w, b.w),
/// and the weights change by dN_i/dxi dxi + dN_i/deta deta. 0 for a face without area.
///   way  in the plane of the face [length]
Eigen::Vector4d weights_of_way(const MovingFace& face, const Eigen::Vector3d& way);

/// A point that projects onto the plane of a face beyond its edges, in the linear extension of the face.
struct PlanePoint {
  Eigen::Vector4d weights;  ///< of the corners, sum 1 [1]
  Eigen::Vector3d normal;   ///< unit, out of the face [1]
  double gap = 0.0;         ///< along the normal, < 0 behind [length]
  double beyond = 0.0;      ///< how far it is from the face, seen along the normal [length]
};

/// The projection of a point onto the plane of a face.
PlanePoint project_onto_plane(const MovingFace& face, const Eigen::Vector3d& point);

}  // namespace contactsim
