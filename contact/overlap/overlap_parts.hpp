// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/definition/declarations.hpp"

namespace contactsim {

/// Faces face each other when the cosine of their normals is less; edges cross along the normals when that
/// of the normals with the way out is as far from 0.
inline constexpr double facing_cosine = -0.7;

/// What overlap removal knows of a contact face.
struct OverlapFace {
  double size = 0.0;            ///< root of its area [length]
  double half_thickness = 0.0;  ///< half the thickness of its solid, or of its lofted shell; else 0 [length]
};

/// What overlap removal knows of a node of a contact surface; one on several surfaces stands once for each.
struct OverlapNode {
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< sum of its faces' area vectors; 0 without any [length^2]
  double size = 0.0;            ///< of its largest face; 0 without any [length]
  double half_thickness = 0.0;  ///< least of its faces, radius of a sphere; else 0 [length]
};

/// What the surfaces of a model are made of, as overlap removal needs it.
struct OverlapParts {
  std::shared_ptr<const ContactMesh> own;  ///< where nobody else has it
  const ContactMesh& contact_mesh;
  IndexedVector<FaceIndex, OverlapFace> of_face;
  IndexedVector<SurfaceNodeIndex, OverlapNode> of_node;

  bool is_lofted(const SurfaceNode& node) const {
    return node.radius > 0.0f || !contact_mesh.is_mesh_point(node.node);
  }
};

/// Whether the element of a side is a solid.
bool is_solid(const Mesh& mesh, ElementSide side);

/// Gathers the parts of a mesh.
///   definition  of the model
OverlapParts make_overlap_parts(const ContactModel& model, const ContactDefinition& definition,
                                const Mesh& mesh);
/// The same of contact nodes as they are now. Their contact mesh must outlive it.
OverlapParts make_overlap_parts(const ContactKinematics& kinematics, const Mesh& mesh);

}  // namespace contactsim
