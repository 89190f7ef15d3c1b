// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_parts.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/definition/rigid_body.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/name_lookup.hpp"
#include "core/rigid/rigid_blocks.hpp"

namespace contactsim {

namespace {

/// Looks up the lines of one set.
class PartFinder {
 public:
  PartFinder(const ConditionLabel& label, const ConditionScope& scope)
      : label_(label), scope_(scope), names_(scope.mesh, aliases_of(scope), scope.diagnostics) {}

  EntityParts find(const EntitySet& set);

 private:
  static std::span<const MeshAlias> aliases_of(const ConditionScope& scope) {
    const FiniteElementModel* model = find_finite_element_model(scope.definition, scope.region);
    return model != nullptr ? std::span(model->aliases) : std::span<const MeshAlias>{};
  }

  void find_named(const std::vector<DeckName>& items, EntityKind kind, std::string_view command,
                  std::vector<NamedEntity>& found);
  void find_assembly(const DeckName& item, std::vector<NamedEntity>& found);
  void find_all_blocks(std::vector<NamedEntity>& found) const;
  void add_checked(const Entity& entity, const DeckName& item, std::vector<NamedEntity>& found);
  bool is_known(std::uint32_t block) const;
  bool is_known(const Entity& entity) const;
  void find_rigid_body(const DeckName& item, std::vector<NamedEntity>& found) const;
  void find_ids(const EntitySet& set, EntityParts& parts);
  void add_error(const DeckLocation& location, std::string text, std::size_t length) {
    scope_.diagnostics.add_error(location, std::move(text), "", static_cast<int>(length));
  }

  const ConditionLabel& label_;
  const ConditionScope& scope_;
  NameLookup names_;
};

bool PartFinder::is_known(std::uint32_t block) const {
  const ElementBlock& of = scope_.mesh.blocks()[block];
  return of.shape != Shape::unknown || of.n_elements == 0;
}

bool PartFinder::is_known(const Entity& entity) const {
  if (entity.kind == EntityKind::block) return is_known(entity.index);
  if (entity.kind != EntityKind::side_set) return true;
  for (const ElementSide side : scope_.mesh.side_sets()[entity.index].sides) {
    if (!is_known(scope_.mesh.block_of(side.element()))) return false;
  }
  return true;
}

void PartFinder::add_checked(const Entity& entity, const DeckName& item, std::vector<NamedEntity>& found) {
  if (is_known(entity)) return found.push_back({entity, item});
  add_error(item.location,
            fmt::format("{} '{}' holds elements of an unknown type, which {} cannot take",
                        to_string(entity.kind), scope_.mesh.name(entity), label_.what),
            item.text.size());
}

void PartFinder::find_named(const std::vector<DeckName>& items, EntityKind kind, std::string_view command,
                            std::vector<NamedEntity>& found) {
  for (const DeckName& item : items) {
    if (const auto entity = names_.find(item, {kind}, command)) add_checked(*entity, item, found);
  }
}

void PartFinder::find_assembly(const DeckName& item, std::vector<NamedEntity>& found) {
  const auto assembly = names_.find(item, {EntityKind::assembly}, "ASSEMBLY");
  if (!assembly) return;
  const std::vector<Entity> members = scope_.mesh.members(assembly->index);
  for (const Entity& member : members) add_checked(member, item, found);
  if (!members.empty()) return;
  add_error(item.location, fmt::format("assembly '{}' holds no block, side set or node set", item.text),
            item.text.size());
}

/// Blocks of unknown types are left to who makes the elements: all of the mesh is used there.
void PartFinder::find_all_blocks(std::vector<NamedEntity>& found) const {
  for (std::uint32_t i = 0; i < scope_.mesh.blocks().size(); ++i) {
    const Entity block{EntityKind::block, i};
    if (is_known(i)) found.push_back({block, {scope_.mesh.name(block), label_.location}});
  }
}

/// Stands for its blocks and node sets. The binder has reported names that no rigid body has.
void PartFinder::find_rigid_body(const DeckName& item, std::vector<NamedEntity>& found) const {
  for (const RigidBodyDefinition& body : scope_.definition.rigid_bodies) {
    if (fold(body.name.text) != fold(item.text)) continue;
    for (const std::uint32_t block : find_rigid_blocks(scope_.definition, scope_.region, scope_.mesh, body))
      found.push_back({{EntityKind::block, block}, item});
    for (const DeckName& name : body.node_sets) {
      if (const auto set = scope_.mesh.find(EntityKind::node_set, name.text))
        found.push_back({{EntityKind::node_set, *set}, item});
    }
  }
}

void PartFinder::find_ids(const EntitySet& set, EntityParts& parts) {
  const auto report = [&](const EntityId& wanted, std::string_view kind) {
    add_error(wanted.location, fmt::format("the mesh has no {} with id {}", kind, wanted.id),
              std::to_string(wanted.id).size());
  };
  for (const EntityId& wanted : set.nodes) {
    const auto node = scope_.mesh.find_node(wanted.id);
    node ? parts.nodes.push_back(*node) : report(wanted, "node");
  }
  for (const EntityId& wanted : set.elements) {
    const auto element = scope_.mesh.find_element(wanted.id);
    element&& is_known(scope_.mesh.block_of(*element)) ? parts.elements.push_back(*element)
                                                       : report(wanted, "element of a known type");
  }
}

EntityParts PartFinder::find(const EntitySet& set) {
  EntityParts parts;
  for (const DeckName& item : set.rigid_bodies) find_rigid_body(item, parts.added);
  if (set.includes_all_blocks) find_all_blocks(parts.added);
  find_named(set.node_sets, EntityKind::node_set, "NODE SET", parts.added);
  find_named(set.side_sets, EntityKind::side_set, "SURFACE", parts.added);
  find_named(set.blocks, EntityKind::block, "BLOCK", parts.added);
  for (const DeckName& item : set.assemblies) find_assembly(item, parts.added);
  find_named(set.removed_node_sets, EntityKind::node_set, "REMOVE NODE SET", parts.removed);
  find_named(set.removed_side_sets, EntityKind::side_set, "REMOVE SURFACE", parts.removed);
  find_named(set.removed_blocks, EntityKind::block, "REMOVE BLOCK", parts.removed);
  find_ids(set, parts);
  return parts;
}

}  // namespace

EntityParts find_parts(const EntitySet& set, const ConditionLabel& label, const ConditionScope& scope) {
  return PartFinder(label, scope).find(set);
}

}  // namespace contactsim
