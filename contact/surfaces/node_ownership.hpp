// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
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
  /// That a request names a node: always by a node set, by a side while its element lives.
  struct Naming {
    std::uint32_t request = 0;
    std::optional<ElementIndex> element;
  };
  /// What one request makes, and whole blocks that it names.
  struct Named {
    SurfaceIndex surface;
    std::vector<std::uint32_t> blocks;  // ascending
  };

  void find_namings(std::span<const SurfaceRequest> requests);
  std::span<const Naming> namings_of(NodeIndex node) const {
    return std::span(namings_).subspan(begin_[node.value], begin_[node.value + 1] - begin_[node.value]);
  }

  const Mesh& mesh_;
  ContactDomain domain_;
  std::vector<Named> requests_;       // those for nodes, in deck order
  std::vector<std::uint32_t> begin_;  // [n_nodes + 1]; empty without requests
  std::vector<Naming> namings_;       // by node, then in deck order
};

}  // namespace contactsim
