// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/claim_rules.hpp"
#include "contact/contact_faces.hpp"
#include "core/face_groups.hpp"

namespace contactsim {

/// The nodes of solids that stay in contact when all their elements are dead: NODAL EROSION = OFF. Which
/// surface has such a node is told by the faces of its dead elements, as if they were outside.
class FreeNodes {
 public:
  /// Both must outlive this.
  ///   erodes  [n_elements] 1 of elements whose nodes leave contact with them
  FreeNodes(const ClaimRules& rules, const FaceGroups& faces, std::vector<std::uint8_t> erodes)
      : rules_(rules), faces_(faces), erodes_(std::move(erodes)) {}

  /// Adds the nodes that deaths have set free.
  ///   dead   elements that have just died
  ///   alive  [n_elements] 0 of all dead elements
  void add(std::span<const ElementIndex> dead, std::span<const std::uint8_t> alive);

  /// Ascending.
  std::span<const FreeNode> nodes() const { return nodes_; }

 private:
  void add(NodeIndex node, std::vector<FreeNode>& found) const;

  const ClaimRules& rules_;
  const FaceGroups& faces_;
  std::vector<std::uint8_t> erodes_;
  std::vector<FreeNode> nodes_;
};

}  // namespace contactsim
