// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/request_parts.hpp"

#include <utility>

#include "contact/surfaces/item_checks.hpp"

namespace contactsim {

SurfaceRequest make_request(std::string name, SurfaceKind kind, std::string command,
                            const DeckLocation& location) {
  SurfaceRequest request;
  request.name = std::move(name);
  request.kind = kind;
  request.command = std::move(command);
  request.location = location;
  return request;
}

void RequestParts::add_item(const DeckName& item, std::span<const EntityKind> kinds,
                            SurfaceRequest& request) {
  for (const Entity& entity : names_.find_members(item, kinds, request.command))
    add_entity(entity, item, request);
}

void RequestParts::add_entity(const Entity& entity, const DeckName& item, SurfaceRequest& request) {
  switch (entity.kind) {
    case EntityKind::block:
      return add_block(entity.index, item.location, request);
    case EntityKind::side_set:
      return add_side_set(entity.index, item, request);
    case EntityKind::node_set:
      request.node_sets.push_back(entity.index);
      return;
    case EntityKind::assembly:
      return;  // find_members opened it
  }
}

void RequestParts::add_block(std::uint32_t block, const DeckLocation& location, SurfaceRequest& request) {
  check_shape(mesh_, block, location);
  request.blocks.push_back(block);
}

void RequestParts::add_side_set(std::uint32_t set, const DeckName& item, SurfaceRequest& request) {
  for (const ElementSide side : mesh_.side_sets()[set].sides)
    check_shape(mesh_, mesh_.block_of(side.element()), item.location);
  const bool is_usable = request.kind == SurfaceKind::node || check_faces(mesh_, set, item, diagnostics_);
  if (is_usable) request.side_sets.push_back(set);
}

}  // namespace contactsim
