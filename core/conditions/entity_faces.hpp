// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/indices.hpp"
#include "core/conditions/condition_scope.hpp"
#include "core/definition/entity_set.hpp"

namespace contactsim {

/// The faces of an entity set, ascending, each once. A side set stands for its faces, interior ones too; a
/// block for its faces on the outside of the whole mesh. What is removed takes its faces away. A set without
/// faces is warned of. Errors: node sets, nodes and elements; sides that are edges or nodes.
///   label  the condition that the set belongs to
std::vector<ElementSide> find_faces(const EntitySet& set, const ConditionLabel& label,
                                    const ConditionScope& scope);

}  // namespace contactsim
