// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// One id of a NODE or ELEMENT line: the user's Exodus id.
struct EntityId {
  std::int64_t id = 0;
  DeckLocation location;
};

/// The mesh parts that a command acts on: the union of what its lines add less the union of what they remove.
/// In a condition a side set or block stands for all of its nodes. Source: Sierra/SM 5.22, mesh entity
/// commands.
struct EntitySet {
  bool includes_all_blocks = false;
  std::vector<DeckName> node_sets, side_sets, blocks, assemblies, rigid_bodies;
  std::vector<EntityId> nodes, elements;
  std::vector<DeckName> removed_node_sets, removed_side_sets, removed_blocks;

  /// Whether any line adds something.
  bool names_something() const {
    return includes_all_blocks || !node_sets.empty() || !side_sets.empty() || !blocks.empty() ||
           !assemblies.empty() || !rigid_bodies.empty() || !nodes.empty() || !elements.empty();
  }
};

}  // namespace contactsim
