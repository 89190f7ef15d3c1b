// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/surfaces/claim.hpp"
#include "contact/surfaces/contact_domain.hpp"
#include "contact/surfaces/node_ownership.hpp"
#include "contact/surfaces/set_sides.hpp"
#include "contact/surfaces/surface_request.hpp"

namespace contactsim {

/// Whether contact lofts the elements of a block: shells, lines and particles.
bool is_lofted(const ElementBlock& block);

/// The subset that a face of the surface goes to, from 1; 0 when it stays.
/// Source: Sierra/SM 5.22, 8.4.4.1.
std::uint32_t choose_subset(const std::vector<SubsetRequest>& subsets, const Mesh& mesh, ElementSide face);

/// The rules of ownership, one face, lofted element or node at a time: requests claim in deck order and the
/// first one owns. Time of an answer grows with the requests that name the thing, not with the mesh.
/// Source: Sierra/SM 5.22, 8.4.
class OwnershipRules {
 public:
  /// mesh, subdomain  must outlive this
  OwnershipRules(std::vector<SurfaceRequest> requests, const Mesh& mesh,
                 const std::optional<ContactSubdomain>& subdomain);

  /// Of a face of a living solid.
  ///   is_exterior  whether no other present element shares it
  Claim of_face(ElementSide face, bool is_exterior) const;
  /// Of a living element of a lofted block.
  LoftedClaim of_lofted(ElementIndex element) const;
  const NodeOwnershipRules& nodes() const { return nodes_; }

  /// [n_elements] 1 of elements of blocks that requests for faces name, and of those that they pick: by these
  /// faces are exterior or not. Source: Sierra/SM 5.22, 8.4.8.
  std::vector<std::uint8_t> find_present() const;
  /// The sides that side sets of these requests hold, ascending: all, and those of one element.
  std::vector<ElementSide> sides() const { return distinct_sides(set_sides_.all()); }
  std::vector<ElementSide> sides_of(ElementIndex element) const {
    return distinct_sides(set_sides_.of(element));
  }
  /// Whether a block form names the block.
  bool is_of_block_form(std::uint32_t block) const { return is_block_form_[block] != 0; }
  std::span<const SurfaceRequest> requests() const { return requests_; }

 private:
  /// A single element that a request names.
  struct Pick {
    ElementIndex element;
    std::uint32_t request = 0;
    auto operator<=>(const Pick&) const = default;
  };
  using Requests = std::vector<std::uint32_t>;  // positions in requests_, ascending

  std::span<const Pick> picks_of(ElementIndex element) const;
  std::span<const std::uint32_t> join(std::span<const std::uint32_t> some, std::span<const Pick> picks,
                                      std::span<const SetSide> set_sides, Requests& joined) const;
  bool is_held(std::span<const SetSide> set_sides, std::uint32_t request) const;
  bool is_removed(std::span<const SetSide> set_sides, std::uint32_t request) const;
  bool claims_body(std::uint32_t request, ElementIndex element) const;
  void add_face(std::uint32_t request, ElementSide face, std::optional<SurfaceIndex> other,
                Claim& claim) const;

  std::vector<SurfaceRequest> requests_;
  const Mesh& mesh_;
  ContactDomain domain_;
  // Of requests for faces:
  std::vector<Requests> of_block_;           // [n_blocks] that name the block
  std::vector<Requests> of_set_;             // [n_side_sets] that hold the set
  std::vector<Pick> picks_;                  // ascending
  SetSides set_sides_;                       // that they hold or remove
  std::vector<std::uint8_t> is_block_form_;  // [n_blocks]
  NodeOwnershipRules nodes_;
};

}  // namespace contactsim
