// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/node_ownership.hpp"

#include <algorithm>

#include "contact/surfaces/sort_once.hpp"

namespace contactsim {

NodeOwnershipRules::NodeOwnershipRules(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                                       const ContactDomain& domain)
    : mesh_(mesh), domain_(domain) {
  for (const SurfaceRequest& request : requests) {
    if (request.kind != SurfaceKind::node) continue;
    Named& named = requests_.emplace_back();
    named.surface = request.first_surface;
    named.blocks = request.blocks;
    for (const std::uint32_t set : request.node_sets) {
      const auto& nodes = mesh.node_sets()[set].nodes;
      named.nodes.insert(named.nodes.end(), nodes.begin(), nodes.end());
    }
    for (const std::uint32_t set : request.side_sets) {
      for (const ElementSide side : mesh.side_sets()[set].sides) {
        for (const NodeIndex node : mesh.side_nodes(side))
          named.side_corners.push_back({node, side.element()});
      }
    }
    sort_once(named.nodes);
    std::ranges::sort(named.side_corners, {}, &SideCorner::key);
  }
}

bool NodeOwnershipRules::needs_elements() const {
  return std::ranges::any_of(requests_, [](const Named& request) { return !request.blocks.empty(); });
}

std::vector<NodeIndex> NodeOwnershipRules::find_claimed() const {
  std::vector<std::uint8_t> is_claimed(mesh_.n_nodes(), 0);
  const auto mark = [&](NodeIndex node) { is_claimed[node.value] = 1; };
  for (const Named& request : requests_) {
    for (const NodeIndex node : request.nodes) mark(node);
    for (const SideCorner& corner : request.side_corners) mark(corner.node);
    for (const std::uint32_t block : request.blocks) std::ranges::for_each(mesh_.blocks()[block].nodes, mark);
  }
  std::vector<NodeIndex> claimed;
  for (std::uint32_t node = 0; node < mesh_.n_nodes(); ++node) {
    if (is_claimed[node] != 0 && domain_.holds(NodeIndex{node})) claimed.push_back({node});
  }
  return claimed;
}

bool NodeOwnershipRules::claims(const Named& request, NodeIndex node, std::span<const ElementIndex> elements,
                                std::span<const std::uint8_t> alive) const {
  const auto is_alive = [&](ElementIndex element) { return alive[element.value] != 0; };
  if (std::ranges::binary_search(request.nodes, node)) return true;
  auto corner = std::ranges::lower_bound(request.side_corners, node, {}, &SideCorner::node);
  for (; corner != request.side_corners.end() && corner->node == node; ++corner) {
    if (is_alive(corner->element)) return true;
  }
  return std::ranges::any_of(elements, [&](ElementIndex element) {
    return is_alive(element) && std::ranges::binary_search(request.blocks, mesh_.block_of(element));
  });
}

Claim NodeOwnershipRules::of_node(NodeIndex node, std::span<const ElementIndex> elements,
                                  std::span<const std::uint8_t> alive) const {
  Claim claim;
  if (!domain_.holds(node)) return claim;
  for (const Named& request : requests_) {
    if (claims(request, node, elements, alive)) claim.add(request.surface, request.surface);
  }
  return claim;
}

}  // namespace contactsim
