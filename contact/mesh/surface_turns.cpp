// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/surface_turns.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace contactsim {

namespace {

/// Twice the area vector of a face, by its diagonals; of a triangle, which repeats its last corner, alike.
template <class Position>
Eigen::Vector3d doubled_area(const ContactFace& face, const Position& x) {
  const auto& corners = face.corners;
  return (x(corners[2]) - x(corners[0])).cross(x(corners[3]) - x(corners[1]));
}

/// The normal of the faces at a node [1]; where faces on both sides cancel, that of the first of them; zero
/// without any area.
template <class Position>
Eigen::Vector3d normal_at(const ContactMesh& contact_mesh, ContactNodeIndex node, const Position& x) {
  constexpr double cancelled = 1e-6;  // of the sum of the squares
  const auto faces = contact_mesh.faces_of_node.of(node);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (const FaceIndex face : faces) {
    const Eigen::Vector3d area = doubled_area(contact_mesh.faces[face], x);
    sum += area;
    squares += area.squaredNorm();
  }
  if (!(sum.squaredNorm() > cancelled * squares)) sum = doubled_area(contact_mesh.faces[faces.front()], x);
  return sum.normalized();  // zero stays
}

/// Axes whose third is a normal, those of space without one.
Eigen::Matrix3d axes_about(const Eigen::Vector3d& normal) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (normal.isZero(0.0)) return axes;
  axes.col(2) = normal;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

}  // namespace

SurfaceTurns::SurfaceTurns(const ContactKinematics& start) : contact_mesh_(&start.contact_mesh()) {
  start_.resize(3, static_cast<Eigen::Index>(contact_mesh_->n_nodes()));
  for (const ContactNodeIndex i : contact_mesh_->nodes()) start_.col(i.value) = start.x(i);
  start_normals_.setZero(3, start_.cols());
  const auto x = [&](ContactNodeIndex i) { return Eigen::Vector3d(start_.col(i.value)); };
  for (const ContactNodeIndex i : contact_mesh_->nodes()) {
    if (has_faces(i)) start_normals_.col(i.value) = normal_at(*contact_mesh_, i, x);
  }
}

bool SurfaceTurns::has_faces(ContactNodeIndex node) const {
  return contact_mesh_ != nullptr && !contact_mesh_->faces_of_node.of(node).empty();
}

Eigen::Matrix3d SurfaceTurns::turn(const ContactKinematics& now, ContactNodeIndex node) const {
  if (!has_faces(node)) return Eigen::Matrix3d::Identity();
  const auto x_now = [&](ContactNodeIndex i) { return Eigen::Vector3d(now.x(i)); };
  const Eigen::Matrix3d from = axes_about(start_normals_.col(node.value)),
                        to = axes_about(normal_at(*contact_mesh_, node, x_now));
  const Eigen::Vector3d centre_start = start_.col(node.value), centre_now = x_now(node);
  // The angle that maximizes the sum of w_start . R w_now over the ways w along the surface.
  double along = 0.0, across = 0.0;
  for (const FaceIndex face : contact_mesh_->faces_of_node.of(node)) {
    for (const ContactNodeIndex corner : contact_mesh_->faces[face].corners) {
      if (corner == node) continue;
      const Eigen::Vector2d before =
                                from.leftCols<2>().transpose() * (start_.col(corner.value) - centre_start),
                            after = to.leftCols<2>().transpose() * (x_now(corner) - centre_now);
      along += before.dot(after);
      across += before.x() * after.y() - before.y() * after.x();
    }
  }
  const double size = std::sqrt(along * along + across * across);
  if (!(size > 0.0)) return to * from.transpose();
  Eigen::Matrix3d about_normal = Eigen::Matrix3d::Identity();
  about_normal(0, 0) = about_normal(1, 1) = along / size;
  about_normal(1, 0) = across / size;
  about_normal(0, 1) = -across / size;
  return to * about_normal * from.transpose();
}

}  // namespace contactsim
