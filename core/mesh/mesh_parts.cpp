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
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) parts.node_ids.push_back(mesh.node_id({i}));
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) parts.element_ids.push_back(mesh.element_id({i}));
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) parts.node_places.push_back(mesh.node_place({i}));
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i)
    parts.element_places.push_back(mesh.element_place({i}));
  return parts;
}

Mesh with_node_sets(const Mesh& mesh, std::span<const NodeSet> more) {
  MeshParts parts = parts_of(mesh);
  std::int64_t id = 0;
  for (const NodeSet& set : parts.node_sets) id = std::max(id, set.id);
  for (const NodeSet& set : more) {
    parts.node_sets.push_back(set);
    parts.node_sets.back().id = ++id;
  }
  return Mesh(std::move(parts));
}

}  // namespace contactsim
