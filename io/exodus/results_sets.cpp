// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <vector>

namespace contactsim {

namespace {

void add_side_set(const Mesh& mesh, const SideSet& set, const std::string& number, ExodusDraft& draft) {
  if (set.sides.empty()) return;
  const int n_sides = draft.add_dimension("num_side_ss" + number, set.sides.size());
  draft.add_integers("elem_ss" + number, {n_sides}, [&mesh, &set] {
    std::vector<std::int32_t> numbers;
    for (const ElementSide& side : set.sides)
      numbers.push_back(static_cast<std::int32_t>(mesh.element_place(side.element())) + 1);
    return numbers;
  });
  draft.add_integers("side_ss" + number, {n_sides}, [&set] {
    std::vector<std::int32_t> numbers;
    for (const ElementSide& side : set.sides) numbers.push_back(side.side());
    return numbers;
  });
  if (set.distribution_factors.empty()) return;
  const int n_factors = draft.add_dimension("num_df_ss" + number, set.distribution_factors.size());
  draft.add_reals("dist_fact_ss" + number, {n_factors}, [&set] { return set.distribution_factors; });
}

void add_node_set(const Mesh& mesh, const NodeSet& set, const std::string& number, ExodusDraft& draft) {
  if (set.nodes.empty()) return;
  const int n_nodes = draft.add_dimension("num_nod_ns" + number, set.nodes.size());
  draft.add_integers("node_ns" + number, {n_nodes}, [&mesh, &set] {
    std::vector<std::int32_t> numbers;
    for (const NodeIndex node : set.nodes)
      numbers.push_back(static_cast<std::int32_t>(mesh.node_place(node)) + 1);
    return numbers;
  });
  if (set.distribution_factors.empty()) return;
  draft.add_reals("dist_fact_ns" + number, {n_nodes}, [&set] { return set.distribution_factors; });
}

std::int64_t member_id(const Mesh& mesh, EntityKind kind, std::uint32_t member) {
  switch (kind) {
    case EntityKind::block:
      return mesh.blocks()[member].id;
    case EntityKind::side_set:
      return mesh.side_sets()[member].id;
    case EntityKind::node_set:
      return mesh.node_sets()[member].id;
    case EntityKind::assembly:
      break;
  }
  return mesh.assemblies()[member].id;
}

// The members that a file can hold: an assembly without members cannot be written, and may be all that
// another one has.
std::vector<std::vector<std::uint32_t>> find_writable_members(const Mesh& mesh) {
  const auto assemblies = mesh.assemblies();
  std::vector<std::vector<std::uint32_t>> members;
  for (const Assembly& assembly : assemblies) {
    members.push_back(assembly.member_kind ? assembly.members : std::vector<std::uint32_t>());
  }
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (std::size_t a = 0; a < assemblies.size(); ++a) {
      if (assemblies[a].member_kind != EntityKind::assembly) continue;
      has_changed |= std::erase_if(members[a], [&](std::uint32_t m) { return members[m].empty(); }) > 0;
    }
  }
  return members;
}

void add_assembly(const Mesh& mesh, std::uint32_t position, const std::vector<std::uint32_t>& members,
                  ExodusDraft& draft) {
  // ex_entity_type of the Exodus library, in the order of EntityKind.
  constexpr std::array types{1, 3, 2, 16};
  constexpr std::array type_names{"element block", "side set", "node set", "assembly"};
  const Assembly& assembly = mesh.assemblies()[position];
  const EntityKind kind = *assembly.member_kind;
  const int n_members =
      draft.add_dimension(fmt::format("num_entity_assembly{}", assembly.id), members.size());
  std::vector<std::int64_t> ids;
  for (std::uint32_t member : members) ids.push_back(member_id(mesh, kind, member));
  const int variable =
      draft.add_ids(fmt::format("assembly_entity{}", assembly.id), n_members, [ids] { return ids; });
  const NetcdfType id_type = draft.format().has_wide_ids ? NetcdfType::int64 : NetcdfType::int32;
  const auto k = static_cast<std::size_t>(kind);
  const std::string name = mesh.name({EntityKind::assembly, position});
  NetcdfOutput& file = draft.file();
  file.set_integer(variable, "_id", id_type, assembly.id);
  file.set_integer(variable, "_type", NetcdfType::int32, types[k]);
  // With the final NUL, as the Exodus library stores and reads them.
  file.set_text(variable, "_name", name + '\0');
  file.set_text(variable, "_typename", type_names[k] + std::string(1, '\0'));
}

}  // namespace

void add_sets(const Mesh& mesh, ExodusDraft& draft) {
  IdRows side_rows, node_rows;
  for (std::uint32_t s = 0; s < mesh.side_sets().size(); ++s) {
    const SideSet& set = mesh.side_sets()[s];
    side_rows.ids.push_back(set.id);
    side_rows.status.push_back(set.sides.empty() ? 0 : 1);
    side_rows.names.push_back(mesh.name({EntityKind::side_set, s}));
    add_side_set(mesh, set, fmt::to_string(s + 1), draft);
  }
  for (std::uint32_t s = 0; s < mesh.node_sets().size(); ++s) {
    const NodeSet& set = mesh.node_sets()[s];
    node_rows.ids.push_back(set.id);
    node_rows.status.push_back(set.nodes.empty() ? 0 : 1);
    node_rows.names.push_back(mesh.name({EntityKind::node_set, s}));
    add_node_set(mesh, set, fmt::to_string(s + 1), draft);
  }
  draft.add_id_rows("num_side_sets", "ss", side_rows);
  draft.add_id_rows("num_node_sets", "ns", node_rows);
}

void add_assemblies(const Mesh& mesh, ExodusDraft& draft) {
  const auto members = find_writable_members(mesh);
  for (std::uint32_t a = 0; a < members.size(); ++a) {
    if (!members[a].empty()) add_assembly(mesh, a, members[a], draft);
  }
}

}  // namespace contactsim
