// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/fours.hpp"
#include "core/elements/model_block.hpp"

/// Between the nodes of a chunk of elements and lanes.
namespace contactsim::batches {

/// The vectors of several fields at the nodes of a chunk of elements of up to so many nodes. Those of a node
/// stand together.
template <std::size_t n_fields, std::size_t n_element_nodes = 8>
class ChunkVectors {
 public:
  ///   nodes   of the mesh
  ///   fields  [3 x n_nodes] each
  template <class... Fields>
  explicit ChunkVectors(std::span<const std::uint32_t> nodes, const Fields&... fields) {
    static_assert(sizeof...(Fields) == n_fields);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      NodeVector* next = &vectors_[n_fields * i];
      ((*next++ << fields.col(nodes[i]), 0.0), ...);
    }
  }

  /// The vectors at the nodes of eight elements, of each field.
  ///   nodes  [n x n_lanes]
  template <std::size_t n, class... Others>
  void gather(const ChunkNode* nodes, NodeVectors<n>& first, Others&... others) const {
    static_assert(1 + sizeof...(Others) == n_fields);
    const double* const vectors = vectors_.data()->data();
    for (std::size_t node = 0; node < n; ++node, nodes += n_lanes) {
      std::array<std::size_t, n_lanes> at;
      for (std::size_t lane = 0; lane < n_lanes; ++lane) at[lane] = n_fields * 4 * nodes[lane];
      const double* field = vectors;
      const auto set = [&](NodeVectors<n>& gathered) {
        const auto lanes = to_lanes([&](std::size_t lane) { return field + at[lane]; });
        for (std::size_t i = 0; i < 3; ++i) gathered[i][node] = lanes[i];
        field += 4;
      };
      set(first);
      (set(others), ...);
    }
  }

 private:
  std::array<NodeVector, n_fields * ModelBlock::batches_per_chunk * n_lanes * n_element_nodes> vectors_;
};

template <class... Fields>
ChunkVectors(std::span<const std::uint32_t>, const Fields&...) -> ChunkVectors<sizeof...(Fields)>;

/// Adds the vectors at the nodes of eight elements up at the nodes, one element after another.
///   n_used  elements that count, from the front
template <std::size_t n>
void scatter_add(const NodeVectors<n>& vectors, const ChunkNode* nodes, std::size_t n_used,
                 NodeVector* sums) {
  for (std::size_t node = 0; node < n; ++node, nodes += n_lanes) {
    for (std::size_t first = 0; first < n_lanes; first += 4) {
      const auto at_nodes = to_vectors(vectors[0][node], vectors[1][node], vectors[2][node], first);
      const auto add = [&](std::size_t lane) {
        double* const sum = sums[nodes[first + lane]].data();
        store_four(sum, load_four(sum) + at_nodes[lane]);
      };
      if (n_used == n_lanes) {  // nearly always: all in registers
        for (std::size_t lane = 0; lane < 4; ++lane) add(lane);
      } else {
        for (std::size_t lane = 0; first + lane < n_used && lane < 4; ++lane) add(lane);
      }
    }
  }
}

}  // namespace contactsim::batches
