// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/multigrid/block_product.hpp"
#include "core/statics/multigrid/chebyshev.hpp"
#include "core/statics/multigrid/group_columns.hpp"

namespace contactsim {

/// (1 - w D^-1 A) T of the columns T of the groups, w = 4/3 over the largest eigenvalue of D^-1 A: motions of
/// the groups that fade into each other, of little energy. Source: Vanek, Mandel and Brezina, Computing 56
/// (1996) 179-196, eq. 6 to 9.
///   smoother  of the matrix
template <int N>
BlockMatrix<N, 6> smooth_columns(const BlockMatrix<N, N>& matrix, const Chebyshev<N>& smoother,
                                 const Aggregates& groups, const GroupColumns<N>& columns) {
  const double damping = 4.0 / 3.0 / smoother.largest();
  const Eigen::Matrix<double, N, N> one = Eigen::Matrix<double, N, N>::Identity();
  return sum_products<N, 6>(matrix.n_rows(), groups.n, [&](std::uint32_t row, const auto& take) {
    if (groups.of_node[row]) take(*groups.of_node[row], one, columns.of_node[row]);
    for (std::size_t k = matrix.first[row]; k < matrix.first[row + std::size_t{1}]; ++k) {
      const std::uint32_t other = matrix.columns[k];
      const OptionalIndex<std::uint32_t> group = groups.of_node[other];
      if (!group) continue;
      const Eigen::Matrix<double, N, N> part = -damping * smoother.inverse(row) * matrix.block(k);
      take(*group, part, columns.of_node[other]);
    }
  });
}

}  // namespace contactsim
