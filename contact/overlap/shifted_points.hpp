// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// The contact nodes while overlap removal moves nodes of the mesh. Points of lofts go along with their node;
/// where the normals of the shells have turned to, a renewal takes over.
class ShiftedPoints {
 public:
  /// The faces must outlive this.
  ShiftedPoints(const ContactMesh& contact_mesh, const Mesh& mesh);
  ShiftedPoints(const ShiftedPoints&) = delete;
  ShiftedPoints& operator=(const ShiftedPoints&) = delete;

  /// Where a contact node is [length].
  Eigen::Vector3d at(ContactNodeIndex point) const;
  FaceCorners corners(const ContactFace& face) const;
  /// How far a side has gone since the last renewal [length].
  Eigen::Vector3d way_of(const ContactPointSide& side) const;

  /// Moves the mesh node of a contact node.
  void shift(ContactNodeIndex point, const Eigen::Vector3d& step) {
    coordinates_.col(contact_mesh_.mesh_nodes[point].value) += step;
  }
  void shift(NodeIndex node, const Eigen::Vector3d& step) { coordinates_.col(node.value) += step; }
  /// Stands the lofts off along the shells' normals as they are now.
  void renew() { renewed_.move_nodes({0.0, 0.0, coordinates_, coordinates_}); }

  /// The contact nodes at the last renewal.
  const ContactKinematics& renewed() const { return renewed_; }
  /// Where the nodes of the mesh are now [3 x n_nodes] [length].
  const Eigen::Matrix3Xd& coordinates() const { return coordinates_; }
  /// Hands out the nodes of the mesh [3 x n_nodes] [length].
  Eigen::Matrix3Xd take() { return std::move(coordinates_); }

 private:
  const ContactMesh& contact_mesh_;
  Eigen::Matrix3Xd coordinates_;  // of the mesh's nodes [length]
  ContactKinematics renewed_;
};

}  // namespace contactsim
