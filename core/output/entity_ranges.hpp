// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/definition/entity_set.hpp"
#include "core/output/output_table.hpp"

namespace contactsim {

/// The nodes of an entity set in runs of neighbours, ascending; all of the mesh when the set names nothing.
std::vector<EntityRange> find_node_ranges(const EntitySet& set, const ConditionLabel& label,
                                          const ConditionScope& scope);

/// The elements of an entity set in runs of neighbours of one block of the model, ascending; all of the model
/// when the set names nothing. Blocks, elements and the elements of side sets are added or removed; node sets
/// and nodes hold no elements, which is an error.
std::vector<EntityRange> find_element_ranges(const EntitySet& set, const ConditionLabel& label,
                                             const ConditionScope& scope, const Model& model);

}  // namespace contactsim
