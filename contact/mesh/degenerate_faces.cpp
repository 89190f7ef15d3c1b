// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/degenerate_faces.hpp"

#include <Eigen/Geometry>

#include "contact/surfaces/sort_once.hpp"

namespace contactsim {

namespace {

/// Whether every corner is turned the same way as the face, by more than a sliver.
bool has_shape(const ContactMesh& contact_mesh, const ContactFace& face,
               const Eigen::Matrix3Xd& coordinates) {
  constexpr double least = 0.01;  // of a square's corner with the face's mean edge
  const int n = face.is_triangle() ? 3 : 4;
  Eigen::Matrix<double, 3, 4> x;
  for (int k = 0; k < 4; ++k)
    x.col(k) = coordinates.col(contact_mesh.mesh_nodes[face.corners[static_cast<std::size_t>(k)]].value);
  x.colwise() -= Eigen::Vector3d(x.col(0));  // large coordinates would cost digits
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  double edges_squared = 0.0;
  for (int k = 0; k < n; ++k) {
    area += x.col(k).cross(x.col((k + 1) % n));
    edges_squared += (x.col((k + 1) % n) - x.col(k)).squaredNorm();
  }
  const Eigen::Vector3d normal = area.stableNormalized();
  for (int k = 0; k < n; ++k) {
    const Eigen::Vector3d on = x.col((k + 1) % n) - x.col(k), back = x.col((k + n - 1) % n) - x.col(k);
    if (!(on.cross(back).dot(normal) > least * edges_squared / n)) return false;
  }
  return true;
}

}  // namespace

std::vector<ElementIndex> find_degenerate_faces(const ContactMesh& contact_mesh,
                                                const Eigen::Matrix3Xd& coordinates) {
  std::vector<ElementIndex> elements;
  for (const ContactFace& face : contact_mesh.faces) {
    const bool is_of_an_edge = contact_mesh.is_lofted(face) && face.side.side() > 2;
    if (!is_of_an_edge && !has_shape(contact_mesh, face, coordinates))
      elements.push_back(face.side.element());
  }
  sort_once(elements);
  return elements;
}

}  // namespace contactsim
