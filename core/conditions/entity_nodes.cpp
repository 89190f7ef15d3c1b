// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/conditions/entity_parts.hpp"

namespace contactsim {

namespace {

/// Marks the nodes of mesh parts.
class NodeMarks {
 public:
  explicit NodeMarks(const Mesh& mesh) : mesh_(mesh), is_marked_(mesh.n_nodes(), 0) {}

  void set(NodeIndex node, bool value) { is_marked_[node.value] = value ? 1 : 0; }
  void set(std::span<const NodeIndex> nodes, bool value) {
    for (const NodeIndex node : nodes) set(node, value);
  }
  void set(const Entity& entity, bool value);
  void set(ElementIndex element, bool value) { set(mesh_.element_nodes(element), value); }

  std::vector<NodeIndex> list() const;

 private:
  void set_side(ElementSide side, bool value);

  const Mesh& mesh_;
  std::vector<std::uint8_t> is_marked_;
};

/// Shapes without sides, such as particles, are their own side.
void NodeMarks::set_side(ElementSide side, bool value) {
  const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(side.element())].shape);
  if (shape.sides.empty()) return set(side.element(), value);
  for (const auto& facet : mesh_.side_facets(side)) set(facet, value);
}

void NodeMarks::set(const Entity& entity, bool value) {
  switch (entity.kind) {
    case EntityKind::block:
      return set(mesh_.blocks()[entity.index].nodes, value);
    case EntityKind::side_set:
      for (const ElementSide side : mesh_.side_sets()[entity.index].sides) set_side(side, value);
      return;
    case EntityKind::node_set:
      return set(mesh_.node_sets()[entity.index].nodes, value);
    case EntityKind::assembly:
      return;  // find_parts opened it
  }
}

std::vector<NodeIndex> NodeMarks::list() const {
  std::vector<NodeIndex> nodes;
  nodes.reserve(static_cast<std::size_t>(std::count(is_marked_.begin(), is_marked_.end(), 1)));
  for (std::uint32_t i = 0; i < is_marked_.size(); ++i) {
    if (is_marked_[i] != 0) nodes.push_back({i});
  }
  return nodes;
}

}  // namespace

std::vector<NodeIndex> find_nodes(const EntitySet& set, const ConditionLabel& label,
                                  const ConditionScope& scope) {
  const std::size_t n_errors = scope.diagnostics.error_count();
  const EntityParts parts = find_parts(set, label, scope);
  NodeMarks marks(scope.mesh);
  for (const NamedEntity& added : parts.added) marks.set(added.entity, true);
  for (const NodeIndex node : parts.nodes) marks.set(node, true);
  for (const ElementIndex element : parts.elements) marks.set(element, true);
  for (const NamedEntity& removed : parts.removed) marks.set(removed.entity, false);
  std::vector<NodeIndex> nodes = marks.list();
  if (nodes.empty() && scope.diagnostics.error_count() == n_errors) {
    scope.diagnostics.add_warning("condition-empty", label.location,
                                  fmt::format("{} acts on no node", label.what));
  }
  return nodes;
}

}  // namespace contactsim
