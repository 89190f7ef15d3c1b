// SPDX-License-Identifier: BSD-3-Clause
// The planes of faces on which nodes slide infinitesimally.
#include <algorithm>
#include <cmath>

#include "contact/formulations/face_plane.hpp"
#include "contact/formulations/node_face/near_faces.hpp"

namespace contactsim {

void NodeFaceContacts::stand_on_plane(const MovingFace& face, const Eigen::Vector3d& x, double radius,
                                      NearFace& near_face) {
  const PlanePoint found = project_onto_plane(face, x);
  near_face.weights = found.weights;
  near_face.beyond = found.beyond;
  near_face.point.normal = found.normal;
  near_face.point.gap = found.gap - radius;
  near_face.distance = std::abs(found.gap);
}

void NodeFaceContacts::choose_planes(NearFaces& near_faces) {
  const auto comes_first = [&](const NearFace& other, const NearFace& plane) {
    if (&other == &plane || other.pair != plane.pair) return false;
    if (!(other.point.normal.dot(plane.point.normal) > NodeHistory::same_wall)) return false;
    if (!other.is_plane) return true;
    return other.beyond < plane.beyond || (other.beyond == plane.beyond && other.face < plane.face);
  };
  const NearFaces all = near_faces;
  near_faces.n = 0;
  for (std::size_t i = 0; i < all.n; ++i) {
    const NearFace& one = all.all[i];
    const auto end = all.all.begin() + static_cast<std::ptrdiff_t>(all.n);
    const bool gives_way = one.is_plane && std::any_of(all.all.begin(), end, [&](const NearFace& other) {
                             return comes_first(other, one);
                           });
    if (!gives_way) near_faces.add(one);
  }
}

}  // namespace contactsim
