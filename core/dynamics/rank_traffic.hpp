// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/dynamics/chunk_shares.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/node_shares.hpp"

namespace contactsim {

/// What ranks tell each other in a step of explicit dynamics: the sums of their chunks at nodes that others
/// follow, rank by rank. Contact, and sums over nodes (104 bytes for 2,048 of them), come on top.
struct RankTraffic {
  int n_ranks = 1;
  double shared_nodes = 0.0;       ///< of all nodes, those that more than one rank follows [1]
  double imbalance = 0.0;          ///< ChunkShares::imbalance() [1]
  std::size_t bytes_gathered = 0;  ///< stable steps and works of all chunks, which every rank gets
  std::size_t n_messages = 0;      ///< of the rank that sends the most bytes: to how many others
  std::size_t bytes_sent = 0;      ///< that it sends
  std::size_t bytes_all = 0;       ///< that all ranks send
};

/// Bytes of the sum that a chunk has at a node: of forces, of shells and beams of moments too.
std::size_t bytes_of_place(const ModelBlock& block);

/// Counts it by who advances and who follows what; the ranks need not be there.
RankTraffic find_traffic(const Model& model, const ChunkShares& chunks, const NodeShares& nodes);

}  // namespace contactsim
