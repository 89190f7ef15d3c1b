// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_model.hpp"

/// The faces, nodes and planes between which overlap removal looks for overlap.
namespace contactsim {

/// A face that nodes may lie behind.
struct OverlapFace {
  std::array<std::uint32_t, 4>
      nodes{};  ///< of the mesh, outward right-hand order; a triangle repeats its last
  std::uint32_t surface = 0;
  ElementSide side;
  double size = 0.0;   ///< root of its area [length]
  double reach = 0.0;  ///< half the thickness of its element; 0 without one [length]

  bool is_triangle() const { return nodes[2] == nodes[3]; }
};

/// A node of a contact surface; one on several surfaces stands once for each.
struct OverlapNode {
  std::uint32_t node = 0;  ///< of the mesh
  std::uint32_t surface = 0;
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< sum of its faces' area vectors; 0 without any [length^2]
  double size = 0.0;            ///< of its largest face; 0 without any [length]
  double reach = 0.0;           ///< least of its faces; 0 without any [length]
};

/// A node that may lie behind a face, or behind a plane.
struct OverlapCandidate {
  std::uint32_t node = 0;     ///< position in OverlapParts::nodes
  std::uint32_t partner = 0;  ///< position in OverlapParts::faces, or of a plane of the region
};

/// Where a pair of surfaces has to be looked at.
struct OverlapSites {
  std::vector<OverlapCandidate> faces;   ///< ascending by node, then by face
  std::vector<OverlapCandidate> planes;  ///< of every node with every plane
};

/// Everything that overlap removal looks at.
struct OverlapParts {
  std::vector<OverlapFace> faces;   ///< by surface
  std::vector<OverlapNode> nodes;   ///< by surface, then by node
  std::vector<OverlapSites> sites;  ///< [n_pairs]
};

/// Gathers faces of elements and nodes of the surfaces that are in a pair, and what is near to what. A node
/// never meets a face of an element that it is part of. Lofted elements are left out.
OverlapParts make_overlap_parts(const ContactModel& model, const Mesh& mesh);

}  // namespace contactsim
