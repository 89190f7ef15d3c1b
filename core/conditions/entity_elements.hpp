// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/indices.hpp"
#include "core/conditions/condition_scope.hpp"
#include "core/definition/entity_set.hpp"

namespace contactsim {

/// The elements of an entity set, ascending, each once: those of blocks and of ELEMENT lines, less removed
/// blocks. A set without elements is warned of. Errors: node sets, side sets, nodes.
///   label     the condition that the set belongs to
///   n_errors  of the diagnostics before the set was gathered: what is empty for a later one is not reported
///   again
std::vector<ElementIndex> find_elements(const EntitySet& set, const ConditionLabel& label,
                                        const ConditionScope& scope, std::size_t n_errors);
/// The same of a set that was gathered without errors.
inline std::vector<ElementIndex> find_elements(const EntitySet& set, const ConditionLabel& label,
                                               const ConditionScope& scope) {
  return find_elements(set, label, scope, scope.diagnostics.error_count());
}

}  // namespace contactsim
