// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel/equal_shares.hpp"

#include <numeric>

namespace contactsim {

std::vector<std::size_t> equal_shares(std::span<const double> costs, int n_ranks) {
  std::vector<std::size_t> begins(static_cast<std::size_t>(n_ranks) + 1, costs.size());
  begins.front() = 0;
  const double all = std::accumulate(costs.begin(), costs.end(), 0.0);
  double so_far = 0.0;
  std::size_t rank = 1;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    while (rank + 1 < begins.size() &&
           so_far + 0.5 * costs[i] >= all * static_cast<double>(rank) / static_cast<double>(n_ranks))
      begins[rank++] = i;
    so_far += costs[i];
  }
  return begins;
}

}  // namespace contactsim
