// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/results_mesh.hpp"

#include "core/base/names.hpp"
#include "core/output/rigid_part.hpp"
#include "io/exodus/exodus_reader.hpp"

namespace contactsim {

Mesh read_results_mesh(const std::string& path, Diagnostics& warnings) {
  Mesh mesh = read_mesh(path, warnings);
  // A run adds it behind all others, so that no other position changes.
  if (mesh.blocks().empty() || fold(mesh.blocks().back().name) != fold(RigidPart::name)) return mesh;
  MeshParts parts;
  parts.path = mesh.path();
  parts.title = mesh.title();
  parts.coordinates = mesh.coordinates();
  parts.blocks.assign(mesh.blocks().begin(), mesh.blocks().end() - 1);
  parts.side_sets.assign(mesh.side_sets().begin(), mesh.side_sets().end());
  parts.node_sets.assign(mesh.node_sets().begin(), mesh.node_sets().end());
  parts.assemblies.assign(mesh.assemblies().begin(), mesh.assemblies().end());
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) parts.node_ids.push_back(mesh.node_id({i}));
  const std::uint32_t n_elements = mesh.n_elements() - mesh.blocks().back().n_elements;
  for (std::uint32_t i = 0; i < n_elements; ++i) parts.element_ids.push_back(mesh.element_id({i}));
  return Mesh(std::move(parts));
}

}  // namespace contactsim
