// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/compare/ownership_table.hpp"

namespace contactsim {

/// A facet of two tables, by its place in each; absent in one that does not have it.
struct FacetMatch {
  std::optional<std::size_t> first, second;
};

/// Every facet of two tables once, by kind, element and side. What one table lists several times is matched
/// in the order of its surfaces.
std::vector<FacetMatch> match_facets(const OwnershipTable& first, const OwnershipTable& second);

/// What of two surfaces is the same: `n` facets that belong to one in the first table and to the other in the
/// second.
struct SurfaceFlow {
  std::size_t from = 0, to = 0;  ///< positions in the first and in the second table
  std::size_t n = 0;
  double area = 0.0;  ///< in the first table [length^2]
};

/// All flows between two tables, by `from`, then `to`.
std::vector<SurfaceFlow> sum_flows(const OwnershipTable& first, const OwnershipTable& second,
                                   const std::vector<FacetMatch>& matches);

/// For each surface of the first table the one of the second that has the same facets, all of them and no
/// others; absent where there is none. [n surfaces of the first]
std::vector<std::optional<std::size_t>> find_same_surfaces(const OwnershipTable& first,
                                                           const OwnershipTable& second,
                                                           const std::vector<SurfaceFlow>& flows);

}  // namespace contactsim
