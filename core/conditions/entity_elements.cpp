// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_elements.hpp"

#include <fmt/format.h>

#include "core/conditions/element_marks.hpp"
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
                                        const ConditionScope& scope, std::size_t n_errors) {
  const EntityParts parts = find_parts(set, label, scope);
  ElementMarks marks(scope.mesh, false);
  const auto mark = [&](const NamedEntity& part, bool value) {
    if (part.entity.kind != EntityKind::block) return report(part, label, scope);
    marks.set(part.entity, value);
  };
  if (!parts.nodes.empty())
    scope.diagnostics.add_error(set.nodes.front().location, label.what + " takes no NODE line", "use BLOCK");
  for (const NamedEntity& added : parts.added) mark(added, true);
  for (const ElementIndex element : parts.elements) marks.set(element, true);
  for (const NamedEntity& removed : parts.removed) mark(removed, false);
  std::vector<ElementIndex> elements = marks.list();
  if (elements.empty() && scope.diagnostics.error_count() == n_errors) {
    scope.diagnostics.add_warning("condition-empty", label.location,
                                  fmt::format("{} acts on no element", label.what));
  }
  return elements;
}

}  // namespace contactsim
