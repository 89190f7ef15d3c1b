// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/ownership_table.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <unordered_map>

#include "app/compare/read_number.hpp"
#include "app/reports/csv.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;

TableSurface surface_of(const Json& row) {
  TableSurface surface;
  surface.name = row.at("name").get<std::string>();
  surface.kind = row.value("kind", "");
  for (const auto& [key, value] : row.items()) {
    if (key == "line") continue;  // which any comment above changes
    if (value.is_number()) surface.figures.emplace_back(key, value.get<double>());
    if (!value.is_object()) continue;
    for (const auto& [part, number] : value.items())
      surface.figures.emplace_back(key + " " + part, number.get<double>());
  }
  for (const Json& lost : row.at("lost_to")) {
    surface.lost_to.emplace_back(lost.at("surface").get<std::string>(),
                                 lost.value("faces", 0) + lost.value("lofted", 0) + lost.value("nodes", 0));
  }
  return surface;
}

TablePair pair_of(const Json& row) {
  TablePair pair{row.at("first").get<std::string>(),
                 row.at("second").get<std::string>(),
                 row.value("interaction", ""),
                 {}};
  for (const auto& [key, value] : row.items()) {
    if (key == "first" || key == "second" || key == "interaction" || key == "line") continue;
    pair.settings.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return pair;
}

/// Positions of names, each of which is listed once.
class NameList {
 public:
  explicit NameList(std::vector<std::string>& names) : names_(names) {
    for (const std::string& name : names) positions_.emplace(name, positions_.size());
  }
  std::uint32_t position_of(const std::string& name) {
    const auto [found, is_new] = positions_.try_emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return static_cast<std::uint32_t>(found->second);
  }

 private:
  std::vector<std::string>& names_;
  std::unordered_map<std::string, std::size_t> positions_;
};

}  // namespace

void read_surfaces_json(const std::string& path, const std::string& text, OwnershipTable& table) {
  try {
    const Json json = Json::parse(text);
    for (const Json& row : json.at("surfaces")) table.surfaces.push_back(surface_of(row));
    table.has_figures = true;
    table.has_pairs = json.contains("pairs");
    if (!table.has_pairs) return;
    for (const Json& row : json["pairs"]) table.pairs.push_back(pair_of(row));
  } catch (const Json::exception& error) {
    throw FileError(path, fmt::format("no ownership table as --surfaces-json writes it ({})", error.what()));
  }
}

void read_surfaces_csv(const std::string& path, const std::string& text, OwnershipTable& table) {
  std::vector<std::string> names;
  for (const TableSurface& surface : table.surfaces) names.push_back(surface.name);
  NameList surfaces(names), kinds(table.kinds), blocks(table.blocks);
  const std::vector<CsvLine> lines = split_csv(text);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto& [number, fields] = lines[i];
    const auto refuse = [&, line = number](const std::string& what) {
      throw FileError(path, fmt::format("line {}: {}", line, what));
    };
    if (fields.size() != 6) refuse(fmt::format("{} fields in place of 6", fields.size()));
    const auto element = read_integer(fields[2]), side = read_integer(fields[3]);
    const auto area = read_number(fields[5]);
    if (!element || !side || !area) refuse("element, side and area should be numbers");
    table.facets.push_back({surfaces.position_of(fields[0]), kinds.position_of(fields[4]), *element, *side,
                            blocks.position_of(fields[1]), *area});
  }
  for (std::size_t i = table.surfaces.size(); i < names.size(); ++i)
    table.surfaces.emplace_back().name = names[i];
  table.has_facets = true;
}

}  // namespace contactsim
