// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/more_node_sets.hpp"

#include <algorithm>
#include <utility>

namespace contactsim {

Mesh with_node_sets(const Mesh& mesh, std::span<const NodeSet> more) {
  if (more.empty()) return mesh;
  MeshParts parts;
  parts.path = mesh.path();
  parts.title = mesh.title();
  parts.coordinates = mesh.coordinates();
  parts.blocks.assign(mesh.blocks().begin(), mesh.blocks().end());
  parts.side_sets.assign(mesh.side_sets().begin(), mesh.side_sets().end());
  parts.node_sets.assign(mesh.node_sets().begin(), mesh.node_sets().end());
  parts.assemblies.assign(mesh.assemblies().begin(), mesh.assemblies().end());
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) parts.node_ids.push_back(mesh.node_id({i}));
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) parts.element_ids.push_back(mesh.element_id({i}));
  std::int64_t id = 0;
  for (const NodeSet& set : parts.node_sets) id = std::max(id, set.id);
  for (const NodeSet& set : more) {
    parts.node_sets.push_back(set);
    parts.node_sets.back().id = ++id;
  }
  return Mesh(std::move(parts));
}

}  // namespace contactsim
