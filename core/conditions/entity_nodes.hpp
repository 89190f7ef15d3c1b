// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/indices.hpp"
#include "core/conditions/condition_scope.hpp"
#include "core/definition/entity_set.hpp"

namespace contactsim {

/// The nodes of an entity set, ascending, each once: what its lines add less what they remove. A side set
/// stands for the nodes of its sides, a block or element for all of its nodes. A set without nodes is warned
/// of.
///   label  the condition that the set belongs to
/// Source: Sierra/SM 5.22, 7.1.1, Boolean operators of entity sets.
std::vector<NodeIndex> find_nodes(const EntitySet& set, const ConditionLabel& label,
                                  const ConditionScope& scope);

}  // namespace contactsim
