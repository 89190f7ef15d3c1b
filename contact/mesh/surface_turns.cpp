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

/// Axes whose third is the normal of the faces; where faces on both sides cancel, that of the first of them.
template <class Position>
Eigen::Matrix3d axes_about(const ContactMesh& contact_mesh, std::uint32_t node, const Position& x) {
  constexpr double cancelled = 1e-3;  // of the sum of the areas
  const auto faces = contact_mesh.faces_of_node.of(node);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double size = 0.0;
  for (const FaceIndex face : faces) {
    const Eigen::Vector3d area = doubled_area(contact_mesh.faces[face], x);
    sum += area;
    size += area.norm();
  }
  if (!(sum.norm() > cancelled * size)) sum = doubled_area(contact_mesh.faces[faces.front()], x);
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (!(sum.norm() > 0.0)) return axes;
  axes.col(2) = sum.normalized();
  axes.col(0) = axes.col(2).unitOrthogonal();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace

SurfaceTurns::SurfaceTurns(const ContactKinematics& start) : contact_mesh_(&start.contact_mesh()) {
  start_.resize(3, static_cast<Eigen::Index>(contact_mesh_->n_nodes()));
  for (std::uint32_t i = 0; i < contact_mesh_->n_nodes(); ++i) start_.col(i) = start.x(i);
}

bool SurfaceTurns::has_faces(std::uint32_t node) const {
  return contact_mesh_ != nullptr && !contact_mesh_->faces_of_node.of(node).empty();
}

Eigen::Matrix3d SurfaceTurns::turn(const ContactKinematics& now, std::uint32_t node) const {
  if (!has_faces(node)) return Eigen::Matrix3d::Identity();
  const auto x_start = [&](std::uint32_t i) { return Eigen::Vector3d(start_.col(i)); };
  const auto x_now = [&](std::uint32_t i) { return Eigen::Vector3d(now.x(i)); };
  const Eigen::Matrix3d from = axes_about(*contact_mesh_, node, x_start),
                        to = axes_about(*contact_mesh_, node, x_now);
  // The angle that maximizes the sum of w_start . R w_now over the ways w along the surface.
  double along = 0.0, across = 0.0;
  for (const FaceIndex face : contact_mesh_->faces_of_node.of(node)) {
    for (const std::uint32_t corner : contact_mesh_->faces[face].corners) {
      const Eigen::Vector3d before = from.transpose() * (x_start(corner) - x_start(node)),
                            after = to.transpose() * (x_now(corner) - x_now(node));
      along += before.head<2>().dot(after.head<2>());
      across += before.x() * after.y() - before.y() * after.x();
    }
  }
  const double size = std::hypot(along, across);
  if (!(size > 0.0)) return to * from.transpose();
  Eigen::Matrix3d about_normal = Eigen::Matrix3d::Identity();
  about_normal(0, 0) = about_normal(1, 1) = along / size;
  about_normal(1, 0) = across / size;
  about_normal(0, 1) = -across / size;
  return to * about_normal * from.transpose();
}

}  // namespace contactsim
