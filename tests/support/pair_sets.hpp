// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "contact/mesh/pair_lists.hpp"
#include "support/catch.hpp"

namespace contactsim::test {

/// Rows with their partners.
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// The pairs of lists, whose partners it checks to ascend.
inline Pairs in_set(const PairTable& lists) {
  Pairs pairs;
  for (std::uint32_t row = 0; row < lists.n_rows(); ++row) {
    CHECK(std::is_sorted(lists.of(row).begin(), lists.of(row).end()));
    for (const std::uint32_t partner : lists.of(row)) pairs.insert({row, partner});
  }
  return pairs;
}

}  // namespace contactsim::test
