// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/surfaces/claim.hpp"
#include "contact/surfaces/contact_domain.hpp"
#include "contact/surfaces/surface_request.hpp"

namespace contactsim {

/// Who owns a node among surfaces of nodes. A request claims the nodes of its node sets whatever dies, and
/// those of living elements: of all elements of its blocks, and of the sides in its side sets.
class NodeOwnershipRules {
 public:
  /// mesh, domain  must outlive this
  NodeOwnershipRules(std::span<const SurfaceRequest> requests, const Mesh& mesh, const ContactDomain& domain);

  bool has_requests() const { return !requests_.empty(); }
  /// Whether requests name blocks, so that a claim depends on all elements of a node.
  bool needs_elements() const;
  /// All nodes that requests claim while every element lives, ascending.
  std::vector<NodeIndex> find_claimed() const;
  /// Who claims a node.
  ///   elements  all that have the node; empty when they are not needed
  ///   alive     [n_elements] 0 of dead elements
  Claim of_node(NodeIndex node, std::span<const ElementIndex> elements,
                std::span<const std::uint8_t> alive) const;

 private:
  /// A corner of a side in a side set.
  struct SideCorner {
    NodeIndex node;
    ElementIndex element;
    std::uint64_t key() const { return std::uint64_t{node.value} << 32 | element.value; }
  };
  /// What one request names.
  struct Named {
    std::uint32_t surface = 0;
    std::vector<std::uint32_t> blocks;     // ascending
    std::vector<NodeIndex> nodes;          // of node sets, ascending
    std::vector<SideCorner> side_corners;  // of side sets, ascending
  };

  bool claims(const Named& request, NodeIndex node, std::span<const ElementIndex> elements,
              std::span<const std::uint8_t> alive) const;

  const Mesh& mesh_;
  ContactDomain domain_;
  std::vector<Named> requests_;  // those for nodes, in deck order
};

}  // namespace contactsim
