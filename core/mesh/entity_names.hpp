// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mesh/id_lookup.hpp"

namespace contactsim {

/// The kinds of mesh entity that a deck can name.
enum class EntityKind : std::uint8_t { block, side_set, node_set, assembly };

inline constexpr std::size_t n_entity_kinds = 4;

/// "block", "side set", "node set", "assembly".
std::string_view to_string(EntityKind kind);

/// block_<id>, surface_<id>, nodelist_<id> or assembly_<id>.
std::string default_name(EntityKind kind, std::int64_t id);

/// The id in a name of the form block_7 (of a block), surface_7 or sideset_7 (of a side set), nodelist_7 or
/// nodeset_7 (of a node set), assembly_7 (of an assembly), case ignored. Source: Sierra/SM's default names.
std::optional<std::int64_t> find_default_id(EntityKind kind, std::string_view name);

/// The name that the entity goes by: the stored one unless it is empty or the default name of another id
/// (block_7 stored on block 9), else the default name.
std::string effective_name(EntityKind kind, std::string_view stored, std::int64_t id);

/// Look-up of the entities of one kind by name, folded, or by default name.
class EntityLookup {
 public:
  EntityLookup() = default;
  /// ids, stored_names  [n]  by position; of a repeated id or name the first is found
  EntityLookup(EntityKind kind, std::vector<std::int64_t> ids, const std::vector<std::string>& stored_names);

  /// Position of the entity that the name means, if there is one.
  std::optional<std::uint32_t> find(std::string_view name) const;

 private:
  EntityKind kind_ = EntityKind::block;
  std::vector<std::int64_t> ids_;
  IdLookup by_id_;
  std::vector<std::pair<std::string, std::uint32_t>> by_name_;  ///< sorted, folded
};

}  // namespace contactsim
