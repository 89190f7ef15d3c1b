// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "core/conditions/entity_parts.hpp"

namespace contactsim {

namespace {

void report(const NamedEntity& part, const ConditionLabel& label, const ConditionScope& scope) {
  scope.diagnostics.add_error(part.name.location,
                              fmt::format("{} acts on elements, but '{}' is a {}", label.what,
                                          scope.mesh.name(part.entity), to_string(part.entity.kind)),
                              "use BLOCK", static_cast<int>(part.name.text.size()));
}

}  // namespace

std::vector<ElementIndex> find_elements(const EntitySet& set, const ConditionLabel& label,
                                        const ConditionScope& scope) {
  const std::size_t n_errors = scope.diagnostics.error_count();
  const EntityParts parts = find_parts(set, label, scope);
  std::vector<std::uint8_t> is_marked(scope.mesh.n_elements(), 0);
  const auto mark = [&](const NamedEntity& part, std::uint8_t value) {
    if (part.entity.kind != EntityKind::block) return report(part, label, scope);
    const ElementBlock& block = scope.mesh.blocks()[part.entity.index];
    std::fill_n(is_marked.begin() + block.first_element.value, block.n_elements, value);
  };
  if (!parts.nodes.empty())
    scope.diagnostics.add_error(set.nodes.front().location, label.what + " takes no NODE line", "use BLOCK");
  for (const NamedEntity& added : parts.added) mark(added, 1);
  for (const ElementIndex element : parts.elements) is_marked[element.value] = 1;
  for (const NamedEntity& removed : parts.removed) mark(removed, 0);
  std::vector<ElementIndex> elements;
  for (std::uint32_t i = 0; i < is_marked.size(); ++i) {
    if (is_marked[i] != 0) elements.push_back({i});
  }
  if (elements.empty() && scope.diagnostics.error_count() == n_errors) {
    scope.diagnostics.add_warning("condition-empty", label.location,
                                  fmt::format("{} acts on no element", label.what));
  }
  return elements;
}

}  // namespace contactsim
