// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/eroded_nodes.hpp"

#include <algorithm>
#include <optional>

#include "contact/surfaces/sort_once.hpp"

namespace contactsim {

std::size_t ErodedNodes::n_nodes() const {
  std::size_t n = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) n += i == 0 || nodes_[i - 1].node != nodes_[i].node ? 1 : 0;
  return n;
}

void ErodedNodes::add_of_faces(const OwnershipRules& rules, NodeIndex node,
                               std::vector<ErodedNode>& found) const {
  const Mesh& mesh = faces_.mesh();
  std::optional<SurfaceIndex> best;
  ElementSide stands_for;
  std::vector<ElementSide> own;
  for (const ElementIndex element : faces_.elements().of(node)) {
    if (topology(mesh.blocks()[mesh.block_of(element)].shape).family != Family::solid) continue;
    faces_.find_faces(element, own);
    for (const ElementSide face : own) {
      const auto has_node = [&](const std::array<NodeIndex, 4>& corners) {
        return std::ranges::find(corners, node) != corners.end();
      };
      if (std::ranges::none_of(mesh.side_facets(face), has_node)) continue;
      const auto owner = rules.of_face(face, true).owner;
      if (!owner || (best && *best <= *owner)) continue;
      best = owner;
      stands_for = face;
    }
  }
  if (best) found.push_back({node, *best, stands_for});
}

/// A node set of the mesh has its nodes still, dead elements or not.
void ErodedNodes::add_of_nodes(const NodeOwnershipRules& nodes, NodeIndex node,
                               std::span<const std::uint8_t> alive, std::vector<ErodedNode>& found) const {
  const auto elements = faces_.elements().of(node);
  if (nodes.of_node(node, elements, alive).owner) return;
  const auto owner = nodes.of_node(node, elements, all_alive_).owner;
  if (owner) found.push_back({node, *owner, ElementSide(elements.front(), 1)});
}

void ErodedNodes::add(const OwnershipRules& rules, std::span<const ElementIndex> dead,
                      std::span<const std::uint8_t> alive) {
  std::vector<NodeIndex> nodes;
  for (const ElementIndex element : dead) {
    const auto own = faces_.mesh().element_nodes(element);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  sort_once(nodes);
  std::vector<ErodedNode> found;
  for (const NodeIndex node : nodes) {
    const auto elements = faces_.elements().of(node);
    const auto is_removed = [&](ElementIndex element) { return alive[element.value] == 0; };
    const auto stays = [&](ElementIndex element) { return erodes_[element.value] == 0; };
    if (std::ranges::all_of(elements, is_removed) && std::ranges::any_of(elements, stays)) {
      add_of_faces(rules, node, found);
      if (rules.nodes().has_requests()) add_of_nodes(rules.nodes(), node, alive, found);
    }
  }
  const auto n_before = static_cast<std::ptrdiff_t>(nodes_.size());
  nodes_.insert(nodes_.end(), found.begin(), found.end());
  std::ranges::inplace_merge(nodes_, nodes_.begin() + n_before, {}, &ErodedNode::node);
}

}  // namespace contactsim
