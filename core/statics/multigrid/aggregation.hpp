// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/optional_index.hpp"
#include "core/statics/multigrid/block_matrix.hpp"

namespace contactsim {

/// How strongly the blocks of a matrix join nodes: |A_ij|^2 / (|A_ii| |A_jj|) by Frobenius' norm, 0 of those
/// on the diagonal and of those not above the square of a threshold. Source: Vanek, Mandel and Brezina,
/// Computing 56 (1996) 179-196, eq. 4.
///   returns [n_blocks]
template <int N>
std::vector<float> find_strengths(const BlockMatrix<N, N>& matrix, double threshold) {
  const std::uint32_t n = matrix.n_rows();
  std::vector<double> own(n, 0.0);
  std::vector<float> strengths(matrix.n_blocks(), 0.0F);
  const int n_threads = threads_for(matrix.n_blocks());
  parallel_for(n, n_threads, [&](std::uint32_t row) {
    if (!matrix.columns_of(row).empty()) own[row] = matrix.block(matrix.place_of(row, row)).norm();
  });
  parallel_for(n, n_threads, [&](std::uint32_t row) {
    for (std::size_t k = matrix.first[row]; k < matrix.first[row + std::size_t{1}]; ++k) {
      const std::uint32_t column = matrix.columns[k];
      const double size = matrix.block(k).squaredNorm(), scale = own[row] * own[column];
      if (column != row && size > threshold * threshold * scale)
        strengths[k] = static_cast<float>(size / scale);
    }
  });
  return strengths;
}

/// Groups of nodes that hang together strongly: each is one node of the next coarser level.
struct Aggregates {
  std::vector<OptionalIndex<std::uint32_t>>
      of_node;  ///< [n_nodes], none of those that nothing joins to others
  std::uint32_t n = 0;
};

/// Groups in the order of the nodes: first nodes with all their strong neighbours, where none of these has a
/// group; then what is left joins the group that it is joined to most strongly. Source: Vanek, Mandel and
/// Brezina (1996), algorithm 2.
///   first, columns  rows of a matrix
///   strengths       [n_blocks] of find_strengths()
Aggregates aggregate(std::span<const std::size_t> first, std::span<const std::uint32_t> columns,
                     std::span<const float> strengths);

}  // namespace contactsim
