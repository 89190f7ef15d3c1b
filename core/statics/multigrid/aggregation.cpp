// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/aggregation.hpp"

namespace contactsim {

Aggregates aggregate(std::span<const std::size_t> first, std::span<const std::uint32_t> columns,
                     std::span<const float> strengths) {
  const auto n_nodes = static_cast<std::uint32_t>(first.size() - 1);
  Aggregates groups{std::vector<OptionalIndex<std::uint32_t>>(n_nodes), 0};
  // Calls take(neighbour, strength) for the strong neighbours of a node.
  const auto visit = [&](std::uint32_t node, const auto& take) {
    for (std::size_t k = first[node]; k < first[node + std::size_t{1}]; ++k) {
      if (strengths[k] > 0.0F) take(columns[k], strengths[k]);
    }
  };
  for (std::uint32_t node = 0; node < n_nodes; ++node) {
    bool is_free = !groups.of_node[node], is_alone = true;
    visit(node, [&](std::uint32_t other, float) {
      is_alone = false;
      is_free = is_free && !groups.of_node[other];
    });
    if (!is_free || is_alone) continue;
    groups.of_node[node] = groups.n;
    visit(node, [&](std::uint32_t other, float) { groups.of_node[other] = groups.n; });
    ++groups.n;
  }
  const std::vector<OptionalIndex<std::uint32_t>> roots = groups.of_node;
  for (std::uint32_t node = 0; node < n_nodes; ++node) {
    if (roots[node]) continue;
    float most = 0.0F;
    visit(node, [&](std::uint32_t other, float strength) {
      if (!roots[other] || !(strength > most)) return;
      most = strength;
      groups.of_node[node] = roots[other];
    });
  }
  return groups;
}

}  // namespace contactsim
