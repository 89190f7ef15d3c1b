// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace contactsim {

/// Cuts a row of items into ranges of about equal cost, one after the other: each ends where its end is
/// nearest to its part of the whole.
///   costs    of the items [any]
///   n_ranks  > 0
/// Returns where the range of each rank begins [n_ranks + 1], the last entry the number of items.
std::vector<std::size_t> equal_shares(std::span<const double> costs, int n_ranks);

}  // namespace contactsim
