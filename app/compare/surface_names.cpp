// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/surface_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "app/compare/describe_order.hpp"

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

/// The surfaces whose names went round: each is in the second what the next one was in the first. Empty when
/// that of one of them is not in the first.
std::vector<std::size_t> find_ring(std::size_t begin, const OwnershipTable& second,
                                   const NamePositions& in_first, const Partners& same) {
  std::vector<std::size_t> ring;
  for (std::size_t i = begin; ring.size() < same.size();) {
    ring.push_back(i);
    if (!same[i]) break;
    const auto next = in_first.find(second.surfaces[*same[i]].name);
    if (next == in_first.end()) break;
    i = next->second;
    if (i == begin) return ring;
  }
  return {};
}

void add_ring(const OwnershipTable& table, const std::vector<std::size_t>& ring,
              std::vector<Difference>& differences) {
  const auto name = [&](std::size_t i) -> const std::string& { return table.surfaces[ring[i]].name; };
  if (ring.size() == 2)
    return add_pair_of_names("swapped", fmt::format("swapped: '{}' and '{}'", name(0), name(1)), name(0),
                             name(1), differences);
  std::string text = fmt::format("'{}'", name(0));
  for (std::size_t i = 1; i <= ring.size(); ++i) text += fmt::format(" is '{}'", name(i % ring.size()));
  differences.push_back({"permuted", fmt::format("permuted: {} in the second", text), {{"surfaces", text}}});
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
    if (const auto found = in_second.find(first.surfaces[i].name); found != in_second.end())
      partners[i] = found->second;
  }
  const Partners by_name = partners;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const std::string& name = first.surfaces[i].name;
    if (!same[i] || same[i] == by_name[i]) continue;
    const std::string& new_name = second.surfaces[*same[i]].name;
    if (!by_name[i] && !in_first.contains(new_name)) {
      partners[i] = same[i];
      add_pair_of_names("renamed", fmt::format("renamed: '{}' is '{}' in the second", name, new_name), name,
                        new_name, differences);
      continue;
    }
    const std::vector<std::size_t> ring = find_ring(i, second, in_first, same);
    if (ring.empty()) continue;
    partners[i] = same[i];
    if (i == std::ranges::min(ring)) add_ring(first, ring, differences);
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
  std::vector<std::string> names;
  std::vector<std::size_t> places;
  for (const std::size_t i : of_first) names.push_back(first.surfaces[i].name);
  for (const std::size_t j : of_second)
    places.push_back(static_cast<std::size_t>(std::ranges::lower_bound(sorted, j) - sorted.begin()));
  differences.push_back({"order",
                         "order: " + describe_order(names, places),
                         {{"from", list_names(first, of_first)}, {"to", list_names(second, sorted)}}});
}

}  // namespace contactsim
