// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/name_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace contactsim {

namespace {

std::string_view article_of(EntityKind kind) { return kind == EntityKind::assembly ? "an" : "a"; }

/// "side set, block or assembly"
std::string list_kinds(std::span<const EntityKind> kinds) {
  std::string text;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i > 0) text += i + 1 == kinds.size() ? " or " : ", ";
    text += to_string(kinds[i]);
  }
  return text;
}

/// "a block and a side set"
std::string list_found(std::span<const Entity> entities) {
  std::vector<std::string> kinds;
  for (const Entity& entity : entities)
    kinds.push_back(fmt::format("{} {}", article_of(entity.kind), to_string(entity.kind)));
  return fmt::format("{}", fmt::join(kinds, " and "));
}

bool contains(std::span<const EntityKind> kinds, EntityKind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace

void NameLookup::add_error(const DeckName& name, std::string text, std::string hint) {
  diagnostics_.add_error(name.location, std::move(text), std::move(hint), static_cast<int>(name.text.size()));
}

/// What the name means on the mesh; the first alias of that spelling counts when the mesh itself has none.
std::vector<Entity> NameLookup::find_all(const DeckName& name) const {
  std::vector<Entity> found = mesh_.find(name.text);
  for (const MeshAlias& alias : aliases_) {
    if (found.empty() && fold(alias.alias.text) == fold(name.text)) found = mesh_.find(alias.mesh_name.text);
  }
  return found;
}

void NameLookup::report_unknown(const DeckName& name, std::span<const EntityKind> kinds,
                                std::string_view command) {
  const auto elsewhere = find_all(name);
  if (!elsewhere.empty()) {
    const bool is_node_set = std::any_of(elsewhere.begin(), elsewhere.end(), [](const Entity& entity) {
      return entity.kind == EntityKind::node_set;
    });
    add_error(name,
              fmt::format("'{}' is {} of the mesh, but {} takes {} {}", name.text, list_found(elsewhere),
                          command, article_of(kinds.front()), list_kinds(kinds)),
              is_node_set ? node_set_hint_ : "");
    return;
  }
  const auto alias = std::find_if(aliases_.begin(), aliases_.end(), [&](const MeshAlias& known) {
    return fold(known.alias.text) == fold(name.text);
  });
  if (alias != aliases_.end()) {
    add_error(
        name,
        fmt::format("the mesh has no '{}', which '{}' is an alias of", alias->mesh_name.text, name.text),
        "the alias stands at " + to_string(alias->alias.location));
    return;
  }
  std::vector<std::string> candidates;
  for (const EntityKind kind : kinds) {
    for (std::string& known : mesh_.names(kind)) candidates.push_back(std::move(known));
  }
  add_error(name, fmt::format("the mesh has no {} '{}'", list_kinds(kinds), name.text),
            suggest(name.text, candidates));
}

std::optional<Entity> NameLookup::find(const DeckName& name, std::span<const EntityKind> kinds,
                                       std::string_view command) {
  std::vector<Entity> found = find_all(name);
  std::erase_if(found, [&](const Entity& entity) { return !contains(kinds, entity.kind); });
  if (found.empty()) {
    report_unknown(name, kinds, command);
    return std::nullopt;
  }
  if (found.size() == 1) return found.front();
  add_error(name, fmt::format("'{}' is the name of {} in the mesh", name.text, list_found(found)),
            "use the name with its id, such as block_<id> or surface_<id>");
  return std::nullopt;
}

std::vector<Entity> NameLookup::find_members(const DeckName& name, std::span<const EntityKind> kinds,
                                             std::string_view command) {
  static constexpr EntityKind faces[] = {EntityKind::block, EntityKind::side_set};
  const auto entity = find(name, kinds, command);
  if (!entity) return {};
  if (entity->kind != EntityKind::assembly) return {*entity};
  const bool only_assembly = kinds.size() == 1;
  const auto allowed = only_assembly ? std::span<const EntityKind>(faces) : kinds;
  std::vector<Entity> members = mesh_.members(entity->index);
  for (const Entity& member : members) {
    if (contains(allowed, member.kind)) continue;
    add_error(name, fmt::format("assembly '{}' holds {} '{}', which {} cannot take", name.text,
                                to_string(member.kind), mesh_.name(member), command));
    return {};
  }
  if (members.empty())
    add_error(name, fmt::format("assembly '{}' holds nothing that {} can take", name.text, command));
  return members;
}

}  // namespace contactsim
