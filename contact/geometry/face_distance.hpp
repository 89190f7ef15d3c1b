// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/face_map.hpp"

namespace contactsim {

/// How far a point is from a face, of which a quadrilateral is two triangles [length].
///   x  corners; a triangle repeats its last [length]
double distance_to_face(const Eigen::Vector3d& point, const FaceCorners& x);

/// How far two faces are from each other, 0 when they cross [length]. Two triangles are nearest at a corner
/// of one or where two of their edges are; they cross where an edge of one goes through the other. Source:
/// Ericson, Real-Time Collision Detection (2005), 5.1.10.
double face_distance(const FaceCorners& first, const FaceCorners& second);

}  // namespace contactsim
