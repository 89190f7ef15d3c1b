// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/ownership_rules.hpp"

#include <algorithm>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "contact/surfaces/sort_once.hpp"

namespace contactsim {

namespace {

std::vector<std::uint8_t> marks(std::size_t n, std::span<const std::uint32_t> marked) {
  std::vector<std::uint8_t> is_marked(n, 0);
  for (const std::uint32_t i : marked) is_marked[i] = 1;
  return is_marked;
}

}  // namespace

OwnershipRules::OwnershipRules(std::vector<SurfaceRequest> requests, const Mesh& mesh,
                               const std::optional<ContactSubdomain>& subdomain)
    : requests_(std::move(requests)),
      mesh_(mesh),
      domain_(mesh, subdomain, {}),
      is_block_form_(mesh.blocks().size(), 0) {
  std::uint32_t surface = 0;
  for (const SurfaceRequest& request : requests_) {
    Named named{surface,
                marks(mesh.blocks().size(), request.blocks),
                marks(mesh.side_sets().size(), request.side_sets),
                marks(mesh.side_sets().size(), request.removed_side_sets),
                {}};
    for (const std::uint32_t set : request.node_sets) {
      const auto& nodes = mesh.node_sets()[set].nodes;
      named.nodes.insert(named.nodes.end(), nodes.begin(), nodes.end());
    }
    sort_once(named.nodes);
    named_.push_back(std::move(named));
    surface += 1 + static_cast<std::uint32_t>(request.subsets.size());
    has_node_requests_ |= request.kind == SurfaceKind::node;
    if (!request.is_block_form) continue;
    for (const std::uint32_t block : request.blocks) is_block_form_[block] = 1;
  }
  add_set_sides();
}

void OwnershipRules::add_set_sides() {
  for (std::uint32_t set = 0; set < mesh_.side_sets().size(); ++set) {
    const bool is_used = std::ranges::any_of(
        named_, [&](const Named& named) { return named.sets[set] != 0 || named.removed_sets[set] != 0; });
    if (!is_used) continue;
    for (const ElementSide side : mesh_.side_sets()[set].sides) set_sides_.push_back({side, set});
  }
  sort_once(set_sides_);
}

std::span<const OwnershipRules::SetSide> OwnershipRules::sets_of(ElementSide side) const {
  return std::ranges::equal_range(set_sides_, side, {}, &SetSide::side);
}

std::vector<ElementSide> OwnershipRules::sides_of(ElementIndex element) const {
  const auto first = std::ranges::lower_bound(set_sides_, ElementSide(element, 1), {}, &SetSide::side);
  std::vector<ElementSide> sides;
  for (auto at = first; at != set_sides_.end() && at->side.element() == element; ++at) {
    if (sides.empty() || sides.back() != at->side) sides.push_back(at->side);
  }
  return sides;
}

bool OwnershipRules::is_in(std::span<const SetSide> places, const std::vector<std::uint8_t>& sets) const {
  return std::ranges::any_of(places, [&](const SetSide& place) { return sets[place.set] != 0; });
}

Claim OwnershipRules::of_face(ElementSide face, bool is_exterior) const {
  Claim claim;
  if (!domain_.holds(face)) return claim;
  const auto sets = sets_of(face);
  const std::uint32_t block = mesh_.block_of(face.element());
  for (std::size_t r = 0; r < requests_.size(); ++r) {
    const Named& named = named_[r];
    if (requests_[r].kind == SurfaceKind::node || is_in(sets, named.removed_sets)) continue;
    if (!(is_exterior && named.blocks[block] != 0) && !is_in(sets, named.sets)) continue;
    if (claim.owner == Claim::nobody) {
      claim.owner = named.surface + choose_subset(requests_[r].subsets, mesh_, face);
    } else {
      claim.lost.push_back({named.surface, claim.owner});
    }
  }
  return claim;
}

bool OwnershipRules::is_picked(const SurfaceRequest& request, ElementIndex element) const {
  return std::ranges::find(request.elements, element) != request.elements.end();
}

bool OwnershipRules::is_removed(std::size_t request, ElementIndex element) const {
  return std::ranges::any_of(sides_of(element), [&](ElementSide side) {
    return is_in(sets_of(side), named_[request].removed_sets);
  });
}

bool OwnershipRules::claims_body(std::size_t request, ElementIndex element) const {
  const bool is_named = named_[request].blocks[mesh_.block_of(element)] != 0;
  if (!is_named && !is_picked(requests_[request], element)) return false;
  return domain_.holds(mesh_.element_nodes(element)) && !is_removed(request, element);
}

LoftedClaim OwnershipRules::of_lofted(ElementIndex element) const {
  LoftedClaim claim;
  for (const ElementSide side : sides_of(element)) {
    if (domain_.holds(side)) claim.sides.push_back(side);
  }
  claim.of_sides.resize(claim.sides.size());
  const auto owner_of_sides = [&] {
    for (const Claim& of_side : claim.of_sides) {
      if (of_side.owner != Claim::nobody) return of_side.owner;
    }
    return Claim::nobody;
  };
  for (std::size_t r = 0; r < requests_.size(); ++r) {
    if (requests_[r].kind == SurfaceKind::node) continue;
    const std::uint32_t surface = named_[r].surface;
    if (claims_body(r, element)) {
      const std::uint32_t owner = claim.body.owner != Claim::nobody ? claim.body.owner : owner_of_sides();
      if (owner == Claim::nobody) {
        claim.body.owner = surface;
      } else {
        claim.body.lost.push_back({surface, owner});
      }
    }
    for (std::size_t i = 0; i < claim.sides.size(); ++i) {
      const auto sets = sets_of(claim.sides[i]);
      if (!is_in(sets, named_[r].sets) || is_in(sets, named_[r].removed_sets)) continue;
      Claim& of_side = claim.of_sides[i];
      const std::uint32_t owner = of_side.owner != Claim::nobody ? of_side.owner : claim.body.owner;
      if (owner == surface) continue;  // the shell is lofted here already
      if (owner == Claim::nobody) {
        of_side.owner = surface + choose_subset(requests_[r].subsets, mesh_, claim.sides[i]);
      } else {
        of_side.lost.push_back({surface, owner});
      }
    }
  }
  return claim;
}

bool OwnershipRules::claims_node(std::size_t request, NodeIndex node, const NodeElements& elements,
                                 std::span<const std::uint8_t> alive) const {
  const Named& named = named_[request];
  if (std::ranges::binary_search(named.nodes, node)) return true;
  return std::ranges::any_of(elements.of(node), [&](ElementIndex element) {
    if (alive[element.value] == 0) return false;
    if (named.blocks[mesh_.block_of(element)] != 0) return true;
    return std::ranges::any_of(sides_of(element), [&](ElementSide side) {
      const auto corners = mesh_.side_nodes(side);
      return is_in(sets_of(side), named.sets) && std::ranges::find(corners, node) != corners.end();
    });
  });
}

Claim OwnershipRules::of_node(NodeIndex node, const NodeElements& elements,
                              std::span<const std::uint8_t> alive) const {
  Claim claim;
  if (!domain_.holds(node)) return claim;
  for (std::size_t r = 0; r < requests_.size(); ++r) {
    if (requests_[r].kind != SurfaceKind::node || !claims_node(r, node, elements, alive)) continue;
    if (claim.owner == Claim::nobody) {
      claim.owner = named_[r].surface;
    } else {
      claim.lost.push_back({named_[r].surface, claim.owner});
    }
  }
  return claim;
}

}  // namespace contactsim
