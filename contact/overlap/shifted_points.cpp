// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/shifted_points.hpp"

namespace contactsim {

ShiftedPoints::ShiftedPoints(const ContactMesh& contact_mesh, const Mesh& mesh)
    : contact_mesh_(contact_mesh), coordinates_(mesh.coordinates()), renewed_(contact_mesh) {
  renew();
}

Eigen::Vector3d ShiftedPoints::at(ContactNodeIndex point) const {
  const Eigen::Vector3d node = coordinates_.col(contact_mesh_.mesh_nodes[point].value);
  const std::size_t first = contact_mesh_.n_mesh_points();
  if (point.value < first) return node;
  return node + renewed_.offsets().col(static_cast<Eigen::Index>(point.value - first));
}

FaceCorners ShiftedPoints::corners(const ContactFace& face) const {
  FaceCorners x;
  for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = at(face.corners[k]);
  return x;
}

Eigen::Vector3d ShiftedPoints::way_of(const ContactPointSide& side) const {
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    way += side.weights[static_cast<Eigen::Index>(k)] * (at(side.nodes[k]) - renewed_.x(side.nodes[k]));
  return way;
}

}  // namespace contactsim
