// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/mesh/contact_mesh.hpp"
#include "contact/surfaces/ownership_rules.hpp"
#include "core/mesh/face_groups.hpp"

namespace contactsim {

/// The nodes that stay in contact when all their elements are dead: NODAL EROSION = OFF. Which surface of
/// faces has such a node of a solid follows from the faces of its dead elements, as if they were outside;
/// which surface of nodes, by what its elements claimed alive.
class ErodedNodes {
 public:
  /// `faces` must outlive this.
  ///   erodes  [n_elements] 1 of elements whose nodes leave contact with them
  ErodedNodes(const FaceGroups& faces, std::vector<std::uint8_t> erodes)
      : faces_(faces), erodes_(std::move(erodes)), all_alive_(erodes_.size(), 1) {}

  /// Adds the nodes that deaths have set free.
  ///   rules  by which the surfaces were resolved
  ///   dead   elements that have just died
  ///   alive  [n_elements] 0 of all dead elements
  void add(const OwnershipRules& rules, std::span<const ElementIndex> dead,
           std::span<const std::uint8_t> alive);

  /// Ascending; a node of two surfaces is there twice.
  std::span<const ErodedNode> nodes() const { return nodes_; }
  std::size_t n_nodes() const;

 private:
  void add_of_faces(const OwnershipRules& rules, NodeIndex node, std::vector<ErodedNode>& found) const;
  void add_of_nodes(const NodeOwnershipRules& nodes, NodeIndex node, std::span<const std::uint8_t> alive,
                    std::vector<ErodedNode>& found) const;

  const FaceGroups& faces_;
  std::vector<std::uint8_t> erodes_, all_alive_;  // [n_elements]
  std::vector<ErodedNode> nodes_;
};

}  // namespace contactsim
