// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace contactsim {

namespace {

/// Drops numbers that are what a function has for every position.
template <class Number, class Function>
void drop_known(const Function& known, std::vector<Number>& numbers) {
  for (std::uint32_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != known(i)) return;
  }
  std::vector<Number>().swap(numbers);
}

template <class Item>
EntityLookup make_lookup(EntityKind kind, const std::vector<Item>& items) {
  std::vector<std::int64_t> ids;
  std::vector<std::string> names;
  for (const Item& item : items) {
    ids.push_back(item.id);
    names.push_back(item.name);
  }
  return EntityLookup(kind, std::move(ids), names);
}

/// Without a map the ids are 1..n in the order of the file.
std::optional<std::uint32_t> find_position(std::span<const std::uint32_t> places, std::int64_t id,
                                           std::uint32_t n) {
  if (id < 1 || id > static_cast<std::int64_t>(n)) return std::nullopt;
  const auto place = static_cast<std::uint32_t>(id - 1);
  const auto found = std::ranges::find(places, place);
  return found == places.end() ? place : static_cast<std::uint32_t>(found - places.begin());
}

}  // namespace

Mesh::Mesh(MeshParts parts) : parts_(std::move(parts)) {
  for (ElementBlock& block : parts_.blocks) {
    block.first_element = {n_elements_};
    n_elements_ += block.n_elements;
  }
  assert(n_elements_ <= max_elements);
  assert(parts_.node_ids.empty() || parts_.node_ids.size() == n_nodes());
  assert(parts_.element_ids.empty() || parts_.element_ids.size() == n_elements_);
  assert(parts_.node_places.size() <= n_nodes() && parts_.element_places.size() <= n_elements_);
  drop_known([&](std::uint32_t i) { return std::int64_t{node_place({i})} + 1; }, parts_.node_ids);
  drop_known([&](std::uint32_t i) { return std::int64_t{element_place({i})} + 1; }, parts_.element_ids);
  for (auto* places : {&parts_.node_places, &parts_.element_places})
    drop_known([](std::uint32_t i) { return i; }, *places);
  node_by_id_ = IdLookup(parts_.node_ids);
  element_by_id_ = IdLookup(parts_.element_ids);
  by_name_ = {make_lookup(EntityKind::block, parts_.blocks),
              make_lookup(EntityKind::side_set, parts_.side_sets),
              make_lookup(EntityKind::node_set, parts_.node_sets),
              make_lookup(EntityKind::assembly, parts_.assemblies)};
}

MeshParts Mesh::release() && { return std::move(parts_); }

Mesh Mesh::with_cohesive_blocks(std::span<const std::uint32_t> blocks) const {
  Mesh copy = *this;
  for (const std::uint32_t index : blocks) {
    Shape& shape = copy.parts_.blocks[index].shape;
    if (shape == Shape::hex8) shape = Shape::cohesive8;
    if (shape == Shape::wedge6) shape = Shape::cohesive6;
  }
  return copy;
}

Mesh Mesh::with_coordinates(Eigen::Matrix3Xd coordinates) const {
  assert(coordinates.cols() == parts_.coordinates.cols());
  Mesh copy = *this;
  copy.parts_.coordinates = std::move(coordinates);
  return copy;
}

std::int64_t Mesh::node_id(NodeIndex node) const {
  return parts_.node_ids.empty() ? std::int64_t{node_place(node)} + 1 : parts_.node_ids[node.value];
}

std::int64_t Mesh::element_id(ElementIndex element) const {
  return parts_.element_ids.empty() ? std::int64_t{element_place(element)} + 1
                                    : parts_.element_ids[element.value];
}

std::optional<ElementIndex> Mesh::find_element(std::int64_t id) const {
  const auto position = parts_.element_ids.empty() ? find_position(parts_.element_places, id, n_elements_)
                                                   : element_by_id_.find(parts_.element_ids, id);
  return position ? std::optional(ElementIndex{*position}) : std::nullopt;
}

std::optional<NodeIndex> Mesh::find_node(std::int64_t id) const {
  const auto position = parts_.node_ids.empty() ? find_position(parts_.node_places, id, n_nodes())
                                                : node_by_id_.find(parts_.node_ids, id);
  return position ? std::optional(NodeIndex{*position}) : std::nullopt;
}

std::uint32_t Mesh::block_of(ElementIndex element) const {
  assert(element.value < n_elements_);
  // Empty blocks share their first element with the block after them; the last of the equals is the holder.
  const auto after =
      std::upper_bound(parts_.blocks.begin(), parts_.blocks.end(), element,
                       [](ElementIndex e, const ElementBlock& block) { return e < block.first_element; });
  return static_cast<std::uint32_t>(after - parts_.blocks.begin()) - 1;
}

std::span<const NodeIndex> Mesh::element_nodes(ElementIndex element) const {
  const ElementBlock& block = parts_.blocks[block_of(element)];
  assert(block.shape != Shape::unknown);
  return block.element_nodes(element.value - block.first_element.value);
}

std::array<NodeIndex, 4> Mesh::side_nodes(ElementSide side) const {
  const ElementBlock& block = parts_.blocks[block_of(side.element())];
  const auto nodes = block.element_nodes(side.element().value - block.first_element.value);
  const std::span<const Side> sides = topology(block.shape).sides;
  assert(static_cast<std::size_t>(side.side()) <= sides.size());
  const auto& corners = sides[static_cast<std::size_t>(side.side()) - 1].corners;
  return {nodes[corners[0]], nodes[corners[1]], nodes[corners[2]], nodes[corners[3]]};
}

SideFacets Mesh::side_facets(ElementSide side) const {
  const ElementBlock& block = parts_.blocks[block_of(side.element())];
  const auto nodes = block.element_nodes(side.element().value - block.first_element.value);
  SideFacets made;
  for (const FacetCorners& c : topology(block.shape).facets(static_cast<std::size_t>(side.side()) - 1))
    made.corners[made.n++] = {nodes[c[0]], nodes[c[1]], nodes[c[2]], nodes[c[3]]};
  return made;
}

std::string Mesh::name(Entity entity) const {
  const auto name_in = [&](const auto& items) {
    return effective_name(entity.kind, items[entity.index].name, items[entity.index].id);
  };
  switch (entity.kind) {
    case EntityKind::block:
      return name_in(parts_.blocks);
    case EntityKind::side_set:
      return name_in(parts_.side_sets);
    case EntityKind::node_set:
      return name_in(parts_.node_sets);
    case EntityKind::assembly:
      break;
  }
  return name_in(parts_.assemblies);
}

std::uint32_t Mesh::count(EntityKind kind) const {
  const std::array counts{parts_.blocks.size(), parts_.side_sets.size(), parts_.node_sets.size(),
                          parts_.assemblies.size()};
  return static_cast<std::uint32_t>(counts[static_cast<std::size_t>(kind)]);
}

std::vector<Entity> Mesh::find(std::string_view name) const {
  std::vector<Entity> found;
  for (std::size_t k = 0; k < n_entity_kinds; ++k) {
    const auto kind = static_cast<EntityKind>(k);
    if (const auto index = find(kind, name)) found.push_back({kind, *index});
  }
  return found;
}

std::optional<std::uint32_t> Mesh::find(EntityKind kind, std::string_view name) const {
  return by_name_[static_cast<std::size_t>(kind)].find(name);
}

std::vector<std::string> Mesh::names(EntityKind kind) const {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < count(kind); ++i) names.push_back(name({kind, i}));
  return names;
}

std::vector<Entity> Mesh::members(std::uint32_t assembly) const {
  std::array<std::vector<bool>, n_entity_kinds> is_seen;
  for (std::size_t k = 0; k < n_entity_kinds; ++k) is_seen[k].resize(count(static_cast<EntityKind>(k)));

  // A stack of our own: files may nest deeper than the call stack.
  std::vector<Entity> found, waiting{{EntityKind::assembly, assembly}};
  while (!waiting.empty()) {
    const Entity entity = waiting.back();
    waiting.pop_back();
    auto seen = is_seen[static_cast<std::size_t>(entity.kind)][entity.index];
    if (seen) continue;
    seen = true;
    if (entity.kind != EntityKind::assembly) {
      found.push_back(entity);
      continue;
    }
    const Assembly& opened = parts_.assemblies[entity.index];
    if (!opened.member_kind) continue;
    for (auto member = opened.members.rbegin(); member != opened.members.rend(); ++member) {
      waiting.push_back({*opened.member_kind, *member});
    }
  }
  return found;
}

}  // namespace contactsim
