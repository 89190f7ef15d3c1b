// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/node_ownership.hpp"

#include <algorithm>
#include <numeric>

namespace contactsim {

namespace {

/// Calls visit(node, element) for the nodes of a request's node sets, without an element, and for the corners
/// of the facets of the sides in its side sets.
template <class Visit>
void visit_named(const SurfaceRequest& request, const Mesh& mesh, const Visit& visit) {
  for (const std::uint32_t set : request.node_sets) {
    for (const NodeIndex node : mesh.node_sets()[set].nodes) visit(node, std::optional<ElementIndex>{});
  }
  for (const std::uint32_t set : request.side_sets) {
    for (const ElementSide side : mesh.side_sets()[set].sides) {
      for (const auto& facet : mesh.side_facets(side)) {
        for (const NodeIndex node : facet) visit(node, std::optional(side.element()));
      }
    }
  }
}

}  // namespace

NodeOwnershipRules::NodeOwnershipRules(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                                       const ContactDomain& domain)
    : mesh_(mesh), domain_(domain) {
  for (const SurfaceRequest& request : requests) {
    if (request.kind == SurfaceKind::node) requests_.push_back({request.first_surface, request.blocks});
  }
  if (has_requests()) find_namings(requests);
}

/// Counting sort by node: how many each has, where they begin, then each to its place.
void NodeOwnershipRules::find_namings(std::span<const SurfaceRequest> requests) {
  begin_.assign(mesh_.n_nodes() + 1, 0);
  const auto visit_all = [&](const auto& visit) {
    std::uint32_t position = 0;
    for (const SurfaceRequest& request : requests) {
      if (request.kind != SurfaceKind::node) continue;
      visit_named(request, mesh_, [&](NodeIndex node, std::optional<ElementIndex> element) {
        visit(node, Naming{position, element});
      });
      ++position;
    }
  };
  visit_all([&](NodeIndex node, const Naming&) { ++begin_[node.value + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  namings_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  visit_all([&](NodeIndex node, const Naming& naming) { namings_[next[node.value]++] = naming; });
}

bool NodeOwnershipRules::needs_elements() const {
  return std::ranges::any_of(requests_, [](const Named& request) { return !request.blocks.empty(); });
}

std::vector<NodeIndex> NodeOwnershipRules::find_claimed() const {
  std::vector<std::uint8_t> is_in_block(mesh_.n_nodes(), 0);
  for (const Named& request : requests_) {
    for (const std::uint32_t block : request.blocks) {
      for (const NodeIndex node : mesh_.blocks()[block].nodes) is_in_block[node.value] = 1;
    }
  }
  std::vector<NodeIndex> claimed;
  for (std::uint32_t i = 0; has_requests() && i < mesh_.n_nodes(); ++i) {
    const NodeIndex node{i};
    const bool is_named = is_in_block[i] != 0 || !namings_of(node).empty();
    if (is_named && domain_.holds(node)) claimed.push_back(node);
  }
  return claimed;
}

Claim NodeOwnershipRules::of_node(NodeIndex node, std::span<const ElementIndex> elements,
                                  std::span<const std::uint8_t> alive) const {
  Claim claim;
  if (!has_requests() || !domain_.holds(node)) return claim;
  const auto is_alive = [&](ElementIndex element) { return alive[element.value] != 0; };
  for (std::uint32_t r = 0; r < requests_.size(); ++r) {
    const Named& request = requests_[r];
    const bool is_named = std::ranges::any_of(namings_of(node), [&](const Naming& naming) {
      return naming.request == r && (!naming.element || is_alive(*naming.element));
    });
    const bool is_in_block = !is_named && std::ranges::any_of(elements, [&](ElementIndex element) {
      return is_alive(element) && std::ranges::binary_search(request.blocks, mesh_.block_of(element));
    });
    if (is_named || is_in_block) claim.add(request.surface, request.surface);
  }
  return claim;
}

}  // namespace contactsim
