// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/block_names.hpp"

namespace contactsim {

std::vector<std::vector<std::string>> find_block_names(const Mesh& mesh, std::span<const MeshAlias> aliases) {
  std::vector<std::vector<std::string>> names(mesh.blocks().size());
  const auto add = [&](const Entity& part, const std::string& name) {
    if (part.kind == EntityKind::block) names[part.index].push_back(name);
    if (part.kind != EntityKind::assembly) return;
    for (const Entity& member : mesh.members(part.index)) {
      if (member.kind == EntityKind::block) names[member.index].push_back(name);
    }
  };
  const auto add_own_names = [&](const Entity& part, std::int64_t id) {
    add(part, mesh.name(part));
    add(part, default_name(part.kind, id));
  };
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i)
    add_own_names({EntityKind::block, i}, mesh.blocks()[i].id);
  for (std::uint32_t i = 0; i < mesh.assemblies().size(); ++i)
    add_own_names({EntityKind::assembly, i}, mesh.assemblies()[i].id);
  for (const MeshAlias& alias : aliases) {
    for (const Entity& part : mesh.find(alias.mesh_name.text)) add(part, alias.alias.text);
  }
  return names;
}

}  // namespace contactsim
