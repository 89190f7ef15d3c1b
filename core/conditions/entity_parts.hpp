// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/definition/entity_set.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A block, side set or node set and the name by which the deck picks it.
struct NamedEntity {
  Entity entity;
  DeckName name;
};

/// What the lines of an entity set name, looked up in the mesh.
struct EntityParts {
  std::vector<NamedEntity> added;  ///< assemblies opened, all blocks listed
  std::vector<NamedEntity> removed;
  std::vector<NodeIndex> nodes;        ///< of NODE lines
  std::vector<ElementIndex> elements;  ///< of ELEMENT lines
};

/// Looks up the parts of an entity set. Errors: names and ids that the mesh does not have, assemblies that
/// hold nothing, parts whose elements are of an unknown type. A rigid body stands for its blocks and node
/// sets.
///   label  the condition that the set belongs to
EntityParts find_parts(const EntitySet& set, const ConditionLabel& label, const ConditionScope& scope);

}  // namespace contactsim
