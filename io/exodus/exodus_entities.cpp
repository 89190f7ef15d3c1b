// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_entities.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <map>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

struct IdArray {
  const char* count;
  const char* ids;
  const char* status;
  const char* names;
};

// Of the kinds that have an id array, in the order of EntityKind.
constexpr std::array<IdArray, 3> id_arrays{{
    {"num_el_blk", "eb_prop1", "eb_status", "eb_names"},
    {"num_side_sets", "ss_prop1", "ss_status", "ss_names"},
    {"num_node_sets", "ns_prop1", "ns_status", "ns_names"},
}};

std::vector<std::int64_t> read_list(const ExodusFile& file, const NetcdfVariable& variable,
                                    std::size_t count) {
  if (variable.shape != std::vector{count}) {
    file.fail(fmt::format("variable {} should have {} values", variable.name, count));
  }
  std::vector<std::int64_t> values(count);
  file.read_int64(variable, values);
  return values;
}

std::vector<std::string> read_names(const ExodusFile& file, const char* variable_name, std::size_t count) {
  const auto variable = file.find_variable(variable_name);
  if (!variable) return std::vector<std::string>(count);
  std::vector<std::string> names = file.read_texts(*variable);
  if (names.size() != count) file.fail(fmt::format("variable {} should have {} names", variable_name, count));
  return names;
}

}  // namespace

std::string describe(EntityKind kind, std::int64_t id, std::string_view name) {
  const std::string plain = fmt::format("{} {}", to_string(kind), id);
  return name.empty() || find_default_id(kind, name) ? plain : fmt::format("{} ({})", plain, name);
}

void warn(Diagnostics& warnings, const ExodusFile& file, std::string_view id, const std::string& text) {
  warnings.add_warning(id, {}, file.path() + ": " + text);
}

std::vector<EntityRow> read_entity_rows(const ExodusFile& file, EntityKind kind, Diagnostics& warnings) {
  assert(static_cast<std::size_t>(kind) < id_arrays.size());
  const IdArray& array = id_arrays[static_cast<std::size_t>(kind)];
  const std::size_t count = file.dimension(array.count);
  if (count == 0) return {};
  const auto ids_variable = file.find_variable(array.ids);
  if (!ids_variable)
    file.fail(fmt::format("has {} {}s but no ids (variable {})", count, to_string(kind), array.ids));
  const std::vector<std::int64_t> ids = read_list(file, *ids_variable, count);
  const auto status_variable = file.find_variable(array.status);
  const auto status =
      status_variable ? read_list(file, *status_variable, count) : std::vector<std::int64_t>(count, 1);
  const std::vector<std::string> names = read_names(file, array.names, count);

  std::vector<EntityRow> rows;
  for (std::size_t i = 0; i < count; ++i) {
    // The Exodus library presets ids with -1; an entity never written keeps that and has status 0.
    if (status[i] == 0 && ids[i] < 0) {
      warn(warnings, file, "mesh-entity-undefined",
           fmt::format("{} number {} was declared and never written", to_string(kind), i + 1));
      continue;
    }
    rows.push_back({i + 1, ids[i], names[i], status[i] == 0});
  }
  check_identities(file, kind, rows, warnings);
  return rows;
}

void check_identities(const ExodusFile& file, EntityKind kind, const std::vector<EntityRow>& rows,
                      Diagnostics& warnings) {
  std::map<std::int64_t, std::size_t> number_of_id;
  std::map<std::string, std::int64_t> id_of_name;
  for (const EntityRow& row : rows) {
    const std::string what = describe(kind, row.id, row.name);
    if (row.id < 0) file.fail(fmt::format("{}: negative id", what));
    const auto [same_id, is_new_id] = number_of_id.emplace(row.id, row.number);
    if (!is_new_id) {
      file.fail(fmt::format("{}: numbers {} and {} of the file's {} list have the same id", what,
                            same_id->second, row.number, to_string(kind)));
    }
    const std::string name = effective_name(kind, row.name, row.id);
    const auto [same_name, is_new_name] = id_of_name.emplace(fold(name), row.id);
    if (!is_new_name) {
      file.fail(fmt::format("{}: {} {} has the same name", what, to_string(kind), same_name->second));
    }
    if (!row.name.empty() && name != row.name) {
      warn(warnings, file, "mesh-name-ignored",
           fmt::format("{} {} is stored under the name '{}', which belongs to another id; it is {}",
                       to_string(kind), row.id, row.name, name));
    }
  }
}

}  // namespace contactsim
