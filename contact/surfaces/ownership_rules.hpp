// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "contact/surfaces/skin_faces.hpp"
#include "contact/surfaces/surface_request.hpp"
#include "core/mesh/node_elements.hpp"

namespace contactsim {

/// Who owns one face, lofted element or node, and who claims it in vain: surfaces by position.
struct Claim {
  static constexpr std::uint32_t nobody = UINT32_MAX;

  /// A surface that claimed in vain, and who had it already.
  struct Lost {
    std::uint32_t loser, winner;
  };
  std::uint32_t owner = nobody;
  std::vector<Lost> lost;
};

/// What all requests claim of a lofted element: its body, and its sides that are in side sets.
struct LoftedClaim {
  Claim body;
  std::vector<ElementSide> sides;
  std::vector<Claim> of_sides;  ///< [sides]
};

/// The rules of ownership one thing at a time: what resolve_surfaces() does for a whole mesh. Time of a
/// look-up does not depend on the mesh's size.
class OwnershipRules {
 public:
  /// mesh, subdomain  must outlive this
  OwnershipRules(std::vector<SurfaceRequest> requests, const Mesh& mesh,
                 const std::optional<ContactSubdomain>& subdomain);

  /// Of a face of a living solid.
  ///   is_exterior  whether no other present element shares it
  Claim of_face(ElementSide face, bool is_exterior) const;
  /// Of a living shell, line or particle.
  LoftedClaim of_lofted(ElementIndex element) const;
  /// Of a node, among surfaces of nodes.
  ///   alive  [n_elements] 0 of dead elements
  Claim of_node(NodeIndex node, const NodeElements& elements, std::span<const std::uint8_t> alive) const;

  bool has_node_requests() const { return has_node_requests_; }
  /// Whether a block form names the block.
  bool is_of_block_form(std::uint32_t block) const { return is_block_form_[block] != 0; }
  /// The sides of an element that side sets of requests hold, ascending, each once.
  std::vector<ElementSide> sides_of(ElementIndex element) const;
  std::span<const SurfaceRequest> requests() const { return requests_; }

 private:
  struct SetSide {
    ElementSide side;
    std::uint32_t set = 0;
    auto operator<=>(const SetSide&) const = default;
  };
  /// What one request names, ready to be looked up.
  struct Named {
    std::uint32_t surface = 0;                             ///< the first that it makes
    std::vector<std::uint8_t> blocks, sets, removed_sets;  ///< [n_blocks], [n_side_sets] twice, 0 or 1
    std::vector<NodeIndex> nodes;                          ///< of node sets, ascending
  };

  void add_set_sides();
  std::span<const SetSide> sets_of(ElementSide side) const;
  bool is_in(std::span<const SetSide> places, const std::vector<std::uint8_t>& sets) const;
  bool is_picked(const SurfaceRequest& request, ElementIndex element) const;
  bool claims_body(std::size_t request, ElementIndex element) const;
  bool claims_node(std::size_t request, NodeIndex node, const NodeElements& elements,
                   std::span<const std::uint8_t> alive) const;
  bool is_removed(std::size_t request, ElementIndex element) const;

  std::vector<SurfaceRequest> requests_;
  const Mesh& mesh_;
  ContactDomain domain_;
  std::vector<Named> named_;                 // [n_requests]
  std::vector<SetSide> set_sides_;           // of all side sets that requests name, ascending
  std::vector<std::uint8_t> is_block_form_;  // [n_blocks]
  bool has_node_requests_ = false;
};

}  // namespace contactsim
