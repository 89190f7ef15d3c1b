// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/compare/comparison.hpp"
#include "app/compare/ownership_table.hpp"

namespace contactsim {

/// What differs between two tables: surfaces that have other names, exchanged theirs, stand in another order
/// or in one table only; what has moved from which surface to which, one difference for each two; figures;
/// pairs. Tables with facets are compared by facets; those without, by figures and by the claims that were
/// lost to others.
///   lists_faces  also tell each facet that moved
std::vector<Difference> compare_ownership(const OwnershipTable& first, const OwnershipTable& second,
                                          const Tolerance& tolerance, bool lists_faces);

}  // namespace contactsim
