// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/surface_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace contactsim {

namespace {

using Partners = std::vector<std::optional<std::size_t>>;
using NamePositions = std::map<std::string, std::size_t>;

NamePositions positions_by_name(const OwnershipTable& table) {
  NamePositions positions;
  for (std::size_t i = 0; i < table.surfaces.size(); ++i) positions.emplace(table.surfaces[i].name, i);
  return positions;
}

void add_pair_of_names(const char* kind, const std::string& text, const std::string& from,
                       const std::string& to, std::vector<Difference>& differences) {
  differences.push_back({kind, text, {{"from", from}, {"to", to}}});
}

bool has_same_figures(const TableSurface& a, const TableSurface& b) {
  return a.kind == b.kind && a.figures == b.figures;
}

/// "a, b, c"
std::string list_names(const OwnershipTable& table, const std::vector<std::size_t>& which) {
  std::string text;
  for (const std::size_t i : which) text += (text.empty() ? "" : ", ") + table.surfaces[i].name;
  return text;
}

/// Whether the names that both have stand in one order; surfaces that swapped theirs do not change it.
///   n_partners  how many surfaces have partners, each by its name
bool has_same_order_of_names(const OwnershipTable& first, const OwnershipTable& second,
                             std::size_t n_partners) {
  const NamePositions in_second = positions_by_name(second);
  std::vector<std::size_t> positions;
  for (const TableSurface& surface : first.surfaces) {
    if (const auto found = in_second.find(surface.name); found != in_second.end())
      positions.push_back(found->second);
  }
  return positions.size() == n_partners && std::ranges::is_sorted(positions);
}

}  // namespace

Partners match_surfaces(const OwnershipTable& first, const OwnershipTable& second, const Partners& same,
                        std::vector<Difference>& differences) {
  const NamePositions in_first = positions_by_name(first), in_second = positions_by_name(second);
  Partners partners(first.surfaces.size());
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const std::string& name = first.surfaces[i].name;
    if (const auto found = in_second.find(name); found != in_second.end()) partners[i] = found->second;
    if (!same[i] || same[i] == partners[i]) continue;
    const std::string& new_name = second.surfaces[*same[i]].name;
    const auto other = in_first.find(new_name);
    if (!partners[i] && other == in_first.end()) {
      partners[i] = same[i];
      add_pair_of_names("renamed", fmt::format("renamed: '{}' is '{}' in the second", name, new_name), name,
                        new_name, differences);
      continue;
    }
    const bool is_swap = partners[i] && other != in_first.end() && same[other->second] == partners[i];
    if (!is_swap) continue;
    partners[i] = same[i];
    if (i < other->second)
      add_pair_of_names("swapped", fmt::format("swapped: '{}' and '{}'", name, new_name), name, new_name,
                        differences);
  }
  return partners;
}

Partners find_same_figures(const OwnershipTable& first, const OwnershipTable& second) {
  Partners same(first.surfaces.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    const TableSurface& surface = first.surfaces[i];
    const auto is_like_it = [&](const TableSurface& other) { return has_same_figures(surface, other); };
    const auto found = std::ranges::find_if(second.surfaces, is_like_it);
    if (found == second.surfaces.end() || std::ranges::count_if(first.surfaces, is_like_it) != 1 ||
        std::ranges::count_if(second.surfaces, is_like_it) != 1)
      continue;
    same[i] = static_cast<std::size_t>(found - second.surfaces.begin());
  }
  return same;
}

void add_unmatched_surfaces(const OwnershipTable& first, const OwnershipTable& second,
                            const Partners& partners, std::vector<Difference>& differences) {
  const auto add = [&](const char* kind, const char* where, const std::string& name) {
    differences.push_back(
        {kind, fmt::format("only in the {}: surface '{}'", where, name), {{"surface", name}}});
  };
  std::vector<std::size_t> of_first, of_second;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (!partners[i]) {
      add("only_in_first", "first", first.surfaces[i].name);
      continue;
    }
    of_first.push_back(i);
    of_second.push_back(*partners[i]);
  }
  const std::set<std::size_t> matched(of_second.begin(), of_second.end());
  for (std::size_t j = 0; j < second.surfaces.size(); ++j) {
    if (!matched.contains(j)) add("only_in_second", "second", second.surfaces[j].name);
  }
  if (std::ranges::is_sorted(of_second) || has_same_order_of_names(first, second, of_first.size())) return;
  std::vector<std::size_t> sorted = of_second;
  std::ranges::sort(sorted);
  const std::string before = list_names(first, of_first), after = list_names(second, sorted);
  differences.push_back(
      {"order", fmt::format("order: {} -> {}", before, after), {{"from", before}, {"to", after}}});
}

}  // namespace contactsim
