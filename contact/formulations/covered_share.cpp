// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/covered_share.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "contact/geometry/common_plane.hpp"
#include "contact/mesh/feature_edges.hpp"

namespace contactsim {

namespace {

/// Faces that turn by more than this cosine have a border between them.
constexpr double smooth_turn = 0.7;

/// A point is beyond an edge when it is by more than this share of the edge's length.
constexpr double rounding = 1e-9;

/// From a point of one part of the mesh to the next, this often at most.
constexpr int max_faces = 64;

/// Whether a point, seen along the normal of a face, is inside the borders of the face's surface. Walks from
/// face to face towards it.
bool is_inside_borders(const ContactKinematics& kinematics, FaceIndex face, const Eigen::Vector3d& point) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const Eigen::Vector3d normal = kinematics.area(contact_mesh.faces[face]).normalized();
  for (int i = 0; i < max_faces; ++i) {
    const ContactFace& here = contact_mesh.faces[face];
    const std::size_t n = here.is_triangle() ? 3 : 4;
    std::optional<FaceIndex> next;
    for (std::size_t k = 0; k < n && !next; ++k) {
      const ContactNodeIndex a = here.corners[k], b = here.corners[(k + 1) % n];
      const Eigen::Vector3d from = kinematics.x(a), along = kinematics.x(b) - from;
      const double inside = normal.dot(along.cross(point - from));
      if (inside >= -rounding * along.squaredNorm()) continue;
      next = find_face_beyond(contact_mesh, face, {a, b});
      if (!next) return false;
      const Eigen::Vector3d beyond = kinematics.area(contact_mesh.faces[*next]).normalized();
      if (!(beyond.dot(normal) > smooth_turn)) return false;
    }
    if (!next) return true;
    face = *next;
  }
  return true;
}

}  // namespace

double covered_share(const ContactKinematics& kinematics, const SurfaceNode& node, FaceIndex face) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const Eigen::Vector3d normal = kinematics.area(contact_mesh.faces[face]).normalized();
  const Eigen::Vector3d at_node = kinematics.x(node.node);
  double all = 0.0, covered = 0.0;
  for (const FaceIndex own : contact_mesh.faces_of_node.of(node.node)) {
    const ContactFace& mine = contact_mesh.faces[own];
    if (mine.surface != node.surface) continue;
    const Eigen::Vector3d area = kinematics.area(mine);
    if (!(area.dot(normal) < facing_limit(mine.sharpness) * area.norm())) continue;
    const std::size_t n = mine.is_triangle() ? 3 : 4;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < n; ++k) centre += kinematics.x(mine.corners[k]) / static_cast<double>(n);
    const double part = std::abs(area.dot(normal)) / static_cast<double>(n);
    all += part;
    if (is_inside_borders(kinematics, face, 0.5 * (at_node + centre))) covered += part;
  }
  return all > 0.0 ? covered / all : 1.0;
}

}  // namespace contactsim
