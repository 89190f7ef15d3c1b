// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_assemblies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "io/exodus/exodus_entities.hpp"

namespace contactsim {

namespace {

constexpr std::string_view assembly_prefix = "assembly_entity";

// Ids of the members, before they are looked up.
struct StoredAssembly {
  EntityRow row;
  std::optional<EntityKind> member_kind;
  std::vector<std::int64_t> member_ids;
};

std::optional<EntityKind> find_member_kind(std::int64_t type) {
  // ex_entity_type of the Exodus library.
  switch (type) {
    case 1:
      return EntityKind::block;
    case 2:
      return EntityKind::node_set;
    case 3:
      return EntityKind::side_set;
    case 16:
      return EntityKind::assembly;
    default:
      return std::nullopt;
  }
}

StoredAssembly read_stored(const ExodusFile& file, const std::string& variable_name, std::size_t number) {
  const auto variable = file.find_variable(variable_name);
  if (!variable) file.fail("variable " + variable_name + " cannot be found");
  const auto id = file.find_integer(*variable, "_id");
  const auto type = file.find_integer(*variable, "_type");
  if (!id || !type) file.fail(fmt::format("assembly {}: no {}", variable_name, id ? "_type" : "_id"));
  StoredAssembly stored;
  stored.row = {number, *id, file.find_text(*variable, "_name").value_or(""), false};
  stored.member_kind = find_member_kind(*type);
  if (!stored.member_kind) return stored;
  if (variable->shape.size() != 1) file.fail("variable " + variable_name + " is not a list");
  stored.member_ids.resize(variable->size());
  file.read_int64(*variable, stored.member_ids);
  return stored;
}

template <class Item>
std::map<std::int64_t, std::uint32_t> index_by_id(const std::vector<Item>& items) {
  std::map<std::int64_t, std::uint32_t> index;
  for (const Item& item : items) index.emplace(item.id, static_cast<std::uint32_t>(index.size()));
  return index;
}

std::string describe(const Assembly& assembly) {
  return describe(EntityKind::assembly, assembly.id, assembly.name);
}

// Takes away assemblies whose nested ones are all taken away; what stays holds a circle.
std::vector<bool> find_circular(const std::vector<Assembly>& assemblies) {
  std::vector<std::vector<std::uint32_t>> holders(assemblies.size());
  std::vector<std::size_t> n_open(assemblies.size(), 0);
  for (std::uint32_t a = 0; a < assemblies.size(); ++a) {
    if (assemblies[a].member_kind != EntityKind::assembly) continue;
    n_open[a] = assemblies[a].members.size();
    for (std::uint32_t member : assemblies[a].members) holders[member].push_back(a);
  }
  std::vector<std::uint32_t> closed;
  for (std::uint32_t a = 0; a < assemblies.size(); ++a) {
    if (n_open[a] == 0) closed.push_back(a);
  }
  std::vector<bool> is_circular(assemblies.size(), true);
  while (!closed.empty()) {
    const std::uint32_t a = closed.back();
    closed.pop_back();
    is_circular[a] = false;
    for (std::uint32_t holder : holders[a]) {
      if (--n_open[holder] == 0) closed.push_back(holder);
    }
  }
  return is_circular;
}

// Throws FileError that names one circle.
void check_nesting(const ExodusFile& file, const std::vector<Assembly>& assemblies) {
  const std::vector<bool> is_circular = find_circular(assemblies);
  const auto first = std::find(is_circular.begin(), is_circular.end(), true);
  if (first == is_circular.end()) return;

  // Whoever is left holds another one that is left, so this walk must meet itself.
  std::vector<std::uint32_t> walk{static_cast<std::uint32_t>(first - is_circular.begin())};
  std::vector<bool> is_walked(assemblies.size(), false);
  while (!is_walked[walk.back()]) {
    is_walked[walk.back()] = true;
    const auto& members = assemblies[walk.back()].members;
    walk.push_back(
        *std::find_if(members.begin(), members.end(), [&](std::uint32_t m) { return is_circular[m]; }));
  }
  const auto start = std::find(walk.begin(), walk.end(), walk.back());
  if (walk.end() - start == 2) file.fail(describe(assemblies[*start]) + " contains itself");
  file.fail(fmt::format("{} contains itself through {}", describe(assemblies[*start]),
                        describe(assemblies[start[1]])));
}

}  // namespace

std::vector<Assembly> read_assemblies(const ExodusFile& file, const MeshParts& parts, Diagnostics& warnings) {
  std::vector<StoredAssembly> all_stored;
  std::vector<EntityRow> rows;
  for (const std::string& variable_name : file.variable_names(assembly_prefix)) {
    all_stored.push_back(read_stored(file, variable_name, all_stored.size() + 1));
    rows.push_back(all_stored.back().row);
  }
  check_identities(file, EntityKind::assembly, rows, warnings);

  std::vector<Assembly> assemblies;
  assemblies.reserve(all_stored.size());
  for (const StoredAssembly& stored : all_stored) {
    assemblies.push_back({stored.row.id, stored.row.name, stored.member_kind, {}});
  }
  const std::array index{index_by_id(parts.blocks), index_by_id(parts.side_sets),
                         index_by_id(parts.node_sets), index_by_id(assemblies)};
  for (std::size_t a = 0; a < assemblies.size(); ++a) {
    for (std::int64_t id : all_stored[a].member_ids) {
      const EntityKind kind = *assemblies[a].member_kind;
      const auto& kind_index = index[static_cast<std::size_t>(kind)];
      const auto member = kind_index.find(id);
      if (member == kind_index.end()) {
        file.fail(
            fmt::format("{}: its member {} {} does not exist", describe(assemblies[a]), to_string(kind), id));
      }
      assemblies[a].members.push_back(member->second);
    }
  }
  check_nesting(file, assemblies);
  return assemblies;
}

}  // namespace contactsim
