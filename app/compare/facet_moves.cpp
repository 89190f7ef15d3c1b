// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/facet_moves.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>
#include <utility>

namespace contactsim {

namespace {

using FacetKey = std::tuple<std::string_view, std::int64_t, std::int64_t>;

FacetKey key_of(const OwnershipTable& table, std::size_t facet) {
  const TableFacet& f = table.facets[facet];
  return {table.kinds[f.kind], f.element, f.side};
}

/// Positions of the facets in the order of their keys, then of their surfaces.
std::vector<std::size_t> sort_facets(const OwnershipTable& table) {
  std::vector<std::size_t> order(table.facets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    const FacetKey of_a = key_of(table, a), of_b = key_of(table, b);
    if (of_a != of_b) return of_a < of_b;
    return std::pair(table.facets[a].surface, a) < std::pair(table.facets[b].surface, b);
  });
  return order;
}

std::vector<std::size_t> count_facets(const OwnershipTable& table) {
  std::vector<std::size_t> n(table.surfaces.size(), 0);
  for (const TableFacet& facet : table.facets) ++n[facet.surface];
  return n;
}

}  // namespace

std::vector<FacetMatch> match_facets(const OwnershipTable& first, const OwnershipTable& second) {
  const std::vector<std::size_t> a = sort_facets(first), b = sort_facets(second);
  std::vector<FacetMatch> matches;
  matches.reserve(std::max(a.size(), b.size()));
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const bool only_a = j == b.size() || (i < a.size() && key_of(first, a[i]) < key_of(second, b[j]));
    const bool only_b = i == a.size() || (j < b.size() && key_of(second, b[j]) < key_of(first, a[i]));
    FacetMatch match;
    if (!only_b) match.first = a[i++];
    if (!only_a) match.second = b[j++];
    matches.push_back(match);
  }
  return matches;
}

std::vector<SurfaceFlow> sum_flows(const OwnershipTable& first, const OwnershipTable& second,
                                   const std::vector<FacetMatch>& matches) {
  std::map<std::pair<std::size_t, std::size_t>, SurfaceFlow> sums;
  for (const FacetMatch& match : matches) {
    if (!match.first || !match.second) continue;
    const TableFacet& facet = first.facets[*match.first];
    const std::size_t from = facet.surface, to = second.facets[*match.second].surface;
    SurfaceFlow& sum = sums.try_emplace({from, to}, SurfaceFlow{from, to}).first->second;
    ++sum.n;
    sum.area += facet.area;
  }
  std::vector<SurfaceFlow> flows;
  for (const auto& [ends, flow] : sums) flows.push_back(flow);
  return flows;
}

std::vector<std::optional<std::size_t>> find_same_surfaces(const OwnershipTable& first,
                                                           const OwnershipTable& second,
                                                           const std::vector<SurfaceFlow>& flows) {
  std::vector<std::optional<std::size_t>> same(first.surfaces.size());
  const std::vector<std::size_t> n_first = count_facets(first), n_second = count_facets(second);
  for (const SurfaceFlow& flow : flows) {
    if (flow.n == n_first[flow.from] && flow.n == n_second[flow.to]) same[flow.from] = flow.to;
  }
  return same;
}

}  // namespace contactsim
