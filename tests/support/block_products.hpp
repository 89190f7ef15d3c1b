// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/multigrid/block_matrix.hpp"

namespace contactsim::test {

/// Sets y to matrix x.
template <int R, int C>
void multiply(const BlockMatrix<R, C>& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  y.resize(Eigen::Index{R} * matrix.n_rows());
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) part_of<R>(y, row) = row_times(matrix, row, x);
}

/// Sets y to the transpose of a matrix times x.
template <int R, int C>
void multiply_transposed(const BlockMatrix<R, C>& matrix, const ColumnPlaces& by_column,
                         const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  y.resize(Eigen::Index{C} * matrix.n_columns);
  for (std::uint32_t column = 0; column < matrix.n_columns; ++column)
    part_of<C>(y, column) = column_times(matrix, by_column, column, x);
}

}  // namespace contactsim::test
