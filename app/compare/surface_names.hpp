// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/compare/comparison.hpp"
#include "app/compare/ownership_table.hpp"

namespace contactsim {

/// Which surface of one table is which of another. By name, but for those that have changed their names or
/// exchanged them, which are reported.
///   same  for each surface of the first table the one of the second that is the same whatever its name
/// Returns for each surface of the first its partner in the second.
std::vector<std::optional<std::size_t>> match_surfaces(const OwnershipTable& first,
                                                       const OwnershipTable& second,
                                                       const std::vector<std::optional<std::size_t>>& same,
                                                       std::vector<Difference>& differences);

/// For each surface of the first table the only one of the second with the same kind and figures.
std::vector<std::optional<std::size_t>> find_same_figures(const OwnershipTable& first,
                                                          const OwnershipTable& second);

/// Tells of surfaces without a partner, and of another order of those that have one.
void add_unmatched_surfaces(const OwnershipTable& first, const OwnershipTable& second,
                            const std::vector<std::optional<std::size_t>>& partners,
                            std::vector<Difference>& differences);

}  // namespace contactsim
