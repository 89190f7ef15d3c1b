// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_ownership.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/compare/compare_pairs.hpp"
#include "app/compare/facet_moves.hpp"
#include "app/compare/surface_names.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

using Partners = std::vector<std::optional<std::size_t>>;

/// Two tables and which surface of one is which of the other.
struct TwoTables {
  const OwnershipTable& first;
  const OwnershipTable& second;
  Partners partners;  ///< [n surfaces of the first] in the second
  const Tolerance& tolerance;
};

void add_move(const std::string& from, const std::string& to, std::int64_t n, std::optional<double> area,
              std::vector<Difference>& differences) {
  Difference moved{
      "moved",
      fmt::format("moved: {} from '{}' to '{}'", pluralize(static_cast<std::size_t>(n), "facet"), from, to),
      {{"from", from}, {"to", to}, {"facets", n}}};
  if (area) {
    moved.text += fmt::format(", area {:.6g}", *area);
    moved.fields.emplace_back("area", *area);
  }
  differences.push_back(std::move(moved));
}

void add_flows(const TwoTables& tables, const std::vector<SurfaceFlow>& flows,
               std::vector<Difference>& differences) {
  for (const SurfaceFlow& flow : flows) {
    if (tables.partners[flow.from] == flow.to) continue;
    add_move(tables.first.surfaces[flow.from].name, tables.second.surfaces[flow.to].name,
             static_cast<std::int64_t>(flow.n), flow.area, differences);
  }
}

/// Facets that one table has alone, by surface.
void add_lone_facets(const TwoTables& tables, const std::vector<FacetMatch>& matches,
                     std::vector<Difference>& differences) {
  std::map<std::uint32_t, std::int64_t> of_first, of_second;
  for (const FacetMatch& match : matches) {
    if (!match.second) ++of_first[tables.first.facets[*match.first].surface];
    if (!match.first) ++of_second[tables.second.facets[*match.second].surface];
  }
  const auto add = [&](const char* kind, const char* where, const OwnershipTable& table, const auto& counts) {
    for (const auto& [surface, n] : counts) {
      const std::string& name = table.surfaces[surface].name;
      differences.push_back({kind,
                             fmt::format("only in the {}: {} of '{}'", where,
                                         pluralize(static_cast<std::size_t>(n), "facet"), name),
                             {{"surface", name}, {"facets", n}}});
    }
  };
  add("facets_only_in_first", "first", tables.first, of_first);
  add("facets_only_in_second", "second", tables.second, of_second);
}

/// Facets of the same surface whose areas differ, by surface.
void add_areas(const TwoTables& tables, const std::vector<FacetMatch>& matches,
               std::vector<Difference>& differences) {
  std::map<std::uint32_t, std::pair<std::int64_t, const FacetMatch*>> changed;  // how many, and the first
  for (const FacetMatch& match : matches) {
    if (!match.first || !match.second) continue;
    const TableFacet &a = tables.first.facets[*match.first], &b = tables.second.facets[*match.second];
    if (!tables.tolerance.is_exceeded(a.area, b.area)) continue;
    auto& [n, one] = changed[a.surface];
    if (n++ == 0) one = &match;
  }
  for (const auto& [surface, found] : changed) {
    const TableFacet& a = tables.first.facets[*found.second->first];
    const double area = tables.second.facets[*found.second->second].area;
    const std::string& name = tables.first.surfaces[surface].name;
    differences.push_back({"area",
                           fmt::format("area: {} of '{}', first element {} side {}: {} -> {}",
                                       pluralize(static_cast<std::size_t>(found.first), "facet"), name,
                                       a.element, a.side, format_value(a.area), format_value(area)),
                           {{"surface", name},
                            {"facets", found.first},
                            {"element", a.element},
                            {"side", a.side},
                            {"first", a.area},
                            {"second", area}}});
  }
}

/// Each facet that has another owner, or is in one table only.
void add_faces(const TwoTables& tables, const std::vector<FacetMatch>& matches,
               std::vector<Difference>& differences) {
  for (const FacetMatch& match : matches) {
    const OwnershipTable& table = match.first ? tables.first : tables.second;
    const TableFacet& facet = table.facets[match.first ? *match.first : *match.second];
    std::string from, to;
    if (match.first) from = tables.first.surfaces[tables.first.facets[*match.first].surface].name;
    if (match.second) to = tables.second.surfaces[tables.second.facets[*match.second].surface].name;
    if (match.first && match.second &&
        tables.partners[tables.first.facets[*match.first].surface] ==
            std::size_t{tables.second.facets[*match.second].surface})
      continue;
    const std::string& kind = table.kinds[facet.kind];
    const std::string owner = [](const std::string& name) {
      return name.empty() ? "nobody" : "'" + name + "'";
    }(from);
    differences.push_back(
        {"face",
         fmt::format("face: block '{}' element {} side {} ({}): {} -> {}", table.blocks[facet.block],
                     facet.element, facet.side, kind, owner, to.empty() ? "nobody" : "'" + to + "'"),
         {{"block", table.blocks[facet.block]},
          {"element", facet.element},
          {"side", facet.side},
          {"facet_kind", kind},
          {"from", from},
          {"to", to}}});
  }
}

/// The names of the second table for surfaces of the first, by their names there.
NewNames names_in_second(const TwoTables& tables) {
  NewNames new_names;
  for (std::size_t i = 0; i < tables.partners.size(); ++i) {
    if (tables.partners[i])
      new_names[tables.first.surfaces[i].name] = tables.second.surfaces[*tables.partners[i]].name;
  }
  return new_names;
}

/// Who keeps how much away from whom, by name.
///   new_names  of the surfaces
std::map<std::pair<std::string, std::string>, std::int64_t> lost_claims(const OwnershipTable& table,
                                                                        const NewNames& new_names) {
  std::map<std::pair<std::string, std::string>, std::int64_t> lost;
  for (const TableSurface& surface : table.surfaces) {
    for (const auto& [winner, n] : surface.lost_to)
      lost[{renamed(winner, new_names), renamed(surface.name, new_names)}] += n;
  }
  return lost;
}

/// Moves that show by claims: what a winner kept away from a loser before, and does no more.
void add_lost_claims(const TwoTables& tables, std::vector<Difference>& differences) {
  const auto before = lost_claims(tables.first, names_in_second(tables)),
             after = lost_claims(tables.second, {});
  std::set<std::pair<std::string, std::string>> ends;
  for (const auto& [winner_loser, n] : before) ends.insert(winner_loser);
  for (const auto& [winner_loser, n] : after) ends.emplace(winner_loser.second, winner_loser.first);
  const auto kept = [](const auto& lost, const std::string& winner, const std::string& loser) {
    const auto found = lost.find({winner, loser});
    return found == lost.end() ? std::int64_t{0} : found->second;
  };
  for (const auto& [from, to] : ends) {
    const std::int64_t less = kept(before, from, to) - kept(after, from, to);
    const std::int64_t more = kept(after, to, from) - kept(before, to, from);
    if (const std::int64_t n = std::max(less, more); n > 0) add_move(from, to, n, std::nullopt, differences);
  }
}

void add_figures(const TwoTables& tables, std::vector<Difference>& differences) {
  for (std::size_t i = 0; i < tables.partners.size(); ++i) {
    if (!tables.partners[i]) continue;
    const TableSurface &a = tables.first.surfaces[i], &b = tables.second.surfaces[*tables.partners[i]];
    std::map<std::string, double> of_b(b.figures.begin(), b.figures.end());
    for (const auto& [name, value] : a.figures) of_b.try_emplace(name, 0.0);
    std::map<std::string, double> of_a(a.figures.begin(), a.figures.end());
    Difference changed{"changed", "", {{"surface", b.name}}};
    for (const auto& [name, value] : of_b) {
      const double before = of_a[name];
      if (!tables.tolerance.is_exceeded(before, value)) continue;
      changed.text += fmt::format("{} {} {} -> {}", changed.text.empty() ? "" : ",", name,
                                  format_value(before), format_value(value));
      changed.fields.emplace_back("first " + name, before);
      changed.fields.emplace_back("second " + name, value);
    }
    if (changed.text.empty()) continue;
    changed.text = fmt::format("changed: '{}'{}", b.name, changed.text);
    differences.push_back(std::move(changed));
  }
}

}  // namespace

std::vector<Difference> compare_ownership(const OwnershipTable& first, const OwnershipTable& second,
                                          const Tolerance& tolerance, bool lists_faces) {
  std::vector<Difference> differences;
  const bool by_facets = first.has_facets && second.has_facets;
  const auto matches = by_facets ? match_facets(first, second) : std::vector<FacetMatch>{};
  const auto flows = sum_flows(first, second, matches);
  const Partners same =
      by_facets ? find_same_surfaces(first, second, flows) : find_same_figures(first, second);
  const TwoTables tables{first, second, match_surfaces(first, second, same, differences), tolerance};
  add_unmatched_surfaces(first, second, tables.partners, differences);
  if (by_facets) {
    add_flows(tables, flows, differences);
    add_lone_facets(tables, matches, differences);
    add_areas(tables, matches, differences);
  } else {
    add_lost_claims(tables, differences);
  }
  if (first.has_figures && second.has_figures) add_figures(tables, differences);
  if (first.has_pairs && second.has_pairs) add_pairs(first, second, names_in_second(tables), differences);
  if (by_facets && lists_faces) add_faces(tables, matches, differences);
  return differences;
}

}  // namespace contactsim
