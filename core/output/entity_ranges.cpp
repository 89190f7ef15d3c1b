// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/entity_ranges.hpp"

#include <fmt/format.h>

#include "core/conditions/element_marks.hpp"
#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/entity_parts.hpp"

namespace contactsim {

namespace {

// Appends an entity to the last range if it follows there, else begins a new one.
void append(std::vector<EntityRange>& ranges, std::size_t block, std::size_t entity) {
  if (!ranges.empty() && ranges.back().block == block &&
      ranges.back().first + ranges.back().count == entity) {
    ++ranges.back().count;
  } else {
    ranges.push_back({block, entity, 1, {}});
  }
}

ElementMarks mark_elements(const EntitySet& set, const ConditionLabel& label, const ConditionScope& scope) {
  ElementMarks marks(scope.mesh, !set.names_something());
  const EntityParts parts = find_parts(set, label, scope);
  const auto mark = [&](const NamedEntity& part, bool value) {
    if (marks.set(part.entity, value)) return;
    scope.diagnostics.add_error(
        part.name.location, fmt::format("{}: the node set {} holds no elements", label.what, part.name.text));
  };
  for (const NamedEntity& part : parts.added) mark(part, true);
  for (const ElementIndex element : parts.elements) marks.set(element, true);
  for (const NamedEntity& part : parts.removed) mark(part, false);
  if (!parts.nodes.empty())
    scope.diagnostics.add_error(label.location, fmt::format("{}: nodes hold no elements", label.what));
  return marks;
}

}  // namespace

std::vector<EntityRange> find_node_ranges(const EntitySet& set, const ConditionLabel& label,
                                          const ConditionScope& scope) {
  if (!set.names_something()) return {{0, 0, scope.mesh.n_nodes(), {}}};
  std::vector<EntityRange> ranges;
  for (const NodeIndex node : find_nodes(set, label, scope)) append(ranges, 0, node.value);
  return ranges;
}

std::vector<EntityRange> find_element_ranges(const EntitySet& set, const ConditionLabel& label,
                                             const ConditionScope& scope, const Model& model) {
  const ElementMarks marks = mark_elements(set, label, scope);
  std::vector<EntityRange> ranges;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const ModelBlock& block = model.blocks[b];
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      if (marks.has({block.first_element.value + e})) append(ranges, b, e);
    }
  }
  return ranges;
}

}  // namespace contactsim
