// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// How the surfaces about contact nodes have turned since the start, by where the nodes of their faces
/// are now and nothing else: it has no memory and makes no error that grows.
class SurfaceTurns {
 public:
  /// Nothing turns.
  SurfaceTurns() = default;
  ///   start  the surfaces at the start
  explicit SurfaceTurns(const ContactKinematics& start);

  /// Whether a node has faces that tell its turn.
  bool has_faces(ContactNodeIndex node) const;
  /// The rotation of the surface about a node [3 x 3] [1]: from the normal of its faces at the start to that
  /// of now, and about it by the angle that fits the ways to the other corners best. The identity for nodes
  /// without faces.
  ///   now  of the same faces as the start
  /// Source: Kabsch (1976), in the plane of the surface.
  Eigen::Matrix3d turn(const ContactKinematics& now, ContactNodeIndex node) const;

 private:
  Eigen::Matrix3Xd start_;                     // [3 x n_contact_nodes] [length]
  Eigen::Matrix3Xd start_normals_;             // [3 x n_contact_nodes] of the faces there [1]
  const ContactMesh* contact_mesh_ = nullptr;  // null: nothing turns
};

}  // namespace contactsim
