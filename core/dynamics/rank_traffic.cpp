// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/rank_traffic.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include "core/elements/element_table.hpp"

namespace contactsim {

std::size_t bytes_of_place(const ModelBlock& block) {
  return (block.element->has_rotations ? 2 : 1) * 3 * sizeof(double);
}

RankTraffic find_traffic(const Model& model, const ChunkShares& chunks, const NodeShares& nodes) {
  const auto n_ranks = static_cast<std::size_t>(chunks.n_ranks());
  std::vector<std::vector<std::size_t>> bytes(n_ranks, std::vector<std::size_t>(n_ranks, 0));
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const ModelBlock& block = model.blocks[b];
    if (block.is_rigid) continue;
    for (std::size_t from = 0; from < n_ranks; ++from) {
      const ChunkRange own = chunks.of(static_cast<int>(from), b);
      for (std::size_t c = own.begin; c < own.end; ++c) {
        if (block.chunks[c].is_subcycled) continue;
        for (const std::uint32_t node : block.nodes_of(block.chunks[c])) {
          for (std::uint64_t left = nodes.followers(node); left != 0; left &= left - 1) {
            const auto to = static_cast<std::size_t>(std::countr_zero(left));
            if (to < n_ranks) bytes[from][to] += bytes_of_place(block);
          }
        }
      }
    }
  }
  RankTraffic traffic;
  traffic.n_ranks = chunks.n_ranks();
  traffic.imbalance = chunks.imbalance();
  traffic.bytes_gathered = chunks.begins().back() * sizeof(ChunkStep);
  for (std::size_t from = 0; from < n_ranks; ++from) {
    std::size_t sent = 0, n_messages = 0;
    for (std::size_t to = 0; to < n_ranks; ++to) {
      if (to == from) continue;
      sent += bytes[from][to];
      n_messages += bytes[from][to] > 0 ? 1 : 0;
    }
    traffic.bytes_all += sent;
    if (sent <= traffic.bytes_sent) continue;
    traffic.bytes_sent = sent;
    traffic.n_messages = n_messages;
  }
  std::size_t n_shared = 0;
  for (std::uint32_t node = 0; node < model.mesh->n_nodes(); ++node)
    n_shared += std::popcount(nodes.followers(node)) > 1 ? 1 : 0;
  if (n_shared > 0)
    traffic.shared_nodes = static_cast<double>(n_shared) / static_cast<double>(model.mesh->n_nodes());
  return traffic;
}

}  // namespace contactsim
