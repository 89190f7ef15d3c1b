// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_plane.hpp"

#include <algorithm>

#include "contact/geometry/node_face.hpp"

namespace contactsim {

Eigen::Vector4d weights_of_way(const MovingFace& face, const Eigen::Vector3d& way) {
  const FaceMap map = make_face_map(face.x, face.is_triangle);
  const Eigen::Vector3d &a = map.c[1], &b = map.c[2];
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), det = aa * bb - ab * ab;
  if (!(det > 0.0)) return Eigen::Vector4d::Zero();
  const double wa = way.dot(a), wb = way.dot(b);
  const double xi = (wa * bb - wb * ab) / det, eta = (wb * aa - wa * ab) / det;
  if (face.is_triangle) return {-xi - eta, xi, eta, 0.0};
  return 0.25 * Eigen::Vector4d(-xi - eta, xi - eta, xi + eta, eta - xi);
}

PlanePoint project_onto_plane(const MovingFace& face, const Eigen::Vector3d& point) {
  const FaceMap map = make_face_map(face.x, face.is_triangle);
  const auto found = project_onto_face(face.x, face.is_triangle, point);
  const Eigen::Vector3d centre = map.centre();
  PlanePoint on_plane;
  on_plane.normal = face.normal();
  // The point of the face next to it; without a projection the middle will do.
  double xi = face.is_triangle ? 1.0 / 3.0 : 0.0, eta = xi;
  if (found && face.is_triangle) {
    xi = std::clamp(found->xi, 0.0, 1.0);
    eta = std::clamp(found->eta, 0.0, 1.0 - xi);
  } else if (found) {
    xi = std::clamp(found->xi, -1.0, 1.0);
    eta = std::clamp(found->eta, -1.0, 1.0);
  }
  const Eigen::Vector3d away = point - map.at(xi, eta);
  on_plane.gap = away.dot(on_plane.normal);
  const Eigen::Vector3d along = away - on_plane.gap * on_plane.normal;
  on_plane.beyond = found ? found->beyond : (point - centre).norm();
  on_plane.weights = corner_weights(xi, eta, face.is_triangle) + weights_of_way(face, along);
  return on_plane;
}

}  // namespace contactsim
