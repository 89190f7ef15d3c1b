// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_faces.hpp"
#include "contact/contact_model.hpp"
#include "core/definition/contact.hpp"

/// The faces, nodes, edges and planes between which overlap removal looks for overlap.
namespace contactsim {

/// What overlap removal knows of a contact face.
struct OverlapFace {
  double size = 0.0;   ///< root of its area [length]
  double reach = 0.0;  ///< half the thickness of its solid, or of its lofted shell; else 0 [length]
};

/// What overlap removal knows of a node of a contact surface; one on several surfaces stands once for each.
struct OverlapNode {
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< sum of its faces' area vectors; 0 without any [length^2]
  double size = 0.0;            ///< of its largest face; 0 without any [length]
  double reach = 0.0;           ///< least of its faces, radius of a ball; else 0 [length]
};

/// Two things that may lie in each other.
struct OverlapCandidate {
  std::uint32_t place = 0;    ///< a surface node or an edge
  std::uint32_t partner = 0;  ///< a face, a plane of the region or another edge
};

/// Where to look for nodes behind something.
struct OverlapSites {
  std::vector<OverlapCandidate> faces;   ///< ascending by node, then by face
  std::vector<OverlapCandidate> planes;  ///< of every node with every plane
};

/// Where a pair of surfaces has to be looked at.
struct PairSites {
  OverlapSites meshed;                  ///< neither side is lofted
  OverlapSites lofted;                  ///< one of them is: a point or a face of a brick, a ball
  std::vector<OverlapCandidate> edges;  ///< rods and balls with each other and with sharp edges

  bool has_lofts() const { return !lofted.faces.empty() || !lofted.planes.empty() || !edges.empty(); }
};

/// Everything that overlap removal looks at.
struct OverlapParts {
  ContactFaces faces;
  std::vector<OverlapFace> of_face;  ///< [n_faces]
  std::vector<OverlapNode> of_node;  ///< [n_surface_nodes]
  std::vector<PairSites> sites;      ///< [n_pairs]

  bool is_lofted(const SurfaceNode& node) const {
    return node.radius > 0.0f || node.node >= faces.n_mesh_points();
  }
};

/// Gathers what the surfaces are made of, and what is near to what in the pairs. A node never meets a face of
/// an element that it is part of, and lofts never what the mesh joins to them within their thickness.
///   definition  of the model
OverlapParts make_overlap_parts(const ContactModel& model, const ContactDefinition& definition,
                                const Mesh& mesh);

}  // namespace contactsim
