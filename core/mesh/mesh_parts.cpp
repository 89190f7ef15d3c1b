// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_parts.hpp"

#include <algorithm>
#include <utility>

namespace contactsim {

namespace {

template <class T>
std::vector<T> copied(std::span<const T> items) {
  return {items.begin(), items.end()};
}

template <class Set>
void append(std::span<const Set> more, std::vector<Set>& sets) {
  std::int64_t id = 0;
  for (const Set& set : sets) id = std::max(id, set.id);
  for (const Set& set : more) {
    sets.push_back(set);
    sets.back().id = ++id;
  }
}

}  // namespace

MeshParts parts_of(const Mesh& mesh) {
  MeshParts parts;
  parts.path = mesh.path();
  parts.title = mesh.title();
  parts.coordinates = mesh.coordinates();
  parts.blocks = copied(mesh.blocks());
  parts.side_sets = copied(mesh.side_sets());
  parts.node_sets = copied(mesh.node_sets());
  parts.assemblies = copied(mesh.assemblies());
  const std::uint32_t n_nodes = mesh.n_nodes(), n_elements = mesh.n_elements();
  parts.node_ids.reserve(n_nodes);
  parts.node_places.reserve(n_nodes);
  for (std::uint32_t i = 0; i < n_nodes; ++i) {
    parts.node_ids.push_back(mesh.node_id({i}));
    parts.node_places.push_back(mesh.node_place({i}));
  }
  parts.element_ids.reserve(n_elements);
  parts.element_places.reserve(n_elements);
  for (std::uint32_t i = 0; i < n_elements; ++i) {
    parts.element_ids.push_back(mesh.element_id({i}));
    parts.element_places.push_back(mesh.element_place({i}));
  }
  return parts;
}

void add_sets(std::span<const SideSet> side_sets, std::span<const NodeSet> node_sets, MeshParts& parts) {
  append(side_sets, parts.side_sets);
  append(node_sets, parts.node_sets);
}

}  // namespace contactsim
