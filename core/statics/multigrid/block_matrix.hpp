// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/threads.hpp"

namespace contactsim {

/// A sparse matrix of dense blocks, row by row: what belongs to a node is a row of blocks.
///   R, C  rows and columns of a block
template <int R, int C>
struct BlockMatrix {
  using Block = Eigen::Matrix<double, R, C>;
  static constexpr std::size_t block_size = std::size_t{R} * C;

  std::uint32_t n_columns = 0;         ///< of blocks
  std::vector<std::size_t> first;      ///< [n_rows + 1] of a row's blocks
  std::vector<std::uint32_t> columns;  ///< [n_blocks] ascending in a row
  std::vector<double> values;          ///< [n_blocks x C x R], blocks by their columns

  std::uint32_t n_rows() const { return static_cast<std::uint32_t>(first.size() - 1); }
  std::size_t n_blocks() const { return columns.size(); }
  std::span<const std::uint32_t> columns_of(std::uint32_t row) const {
    return std::span(columns).subspan(first[row], first[row + std::size_t{1}] - first[row]);
  }
  Eigen::Map<const Block> block(std::size_t place) const {
    return Eigen::Map<const Block>(values.data() + place * block_size);
  }
  Eigen::Map<Block> block(std::size_t place) { return Eigen::Map<Block>(values.data() + place * block_size); }
  /// Where the block of a row and a column stands. Precondition: there is one.
  std::size_t place_of(std::uint32_t row, std::uint32_t column) const {
    const auto of_row = columns_of(row);
    return first[row] +
           static_cast<std::size_t>(std::lower_bound(of_row.begin(), of_row.end(), column) - of_row.begin());
  }
};

/// The part of a vector that belongs to a block row or column.
template <int N>
Eigen::Map<const Eigen::Matrix<double, N, 1>> part_of(const Eigen::VectorXd& vector, std::uint32_t i) {
  return Eigen::Map<const Eigen::Matrix<double, N, 1>>(vector.data() + std::size_t{N} * i);
}
template <int N>
Eigen::Map<Eigen::Matrix<double, N, 1>> part_of(Eigen::VectorXd& vector, std::uint32_t i) {
  return Eigen::Map<Eigen::Matrix<double, N, 1>>(vector.data() + std::size_t{N} * i);
}

/// A row of a matrix times a vector.
template <int R, int C>
Eigen::Matrix<double, R, 1> row_times(const BlockMatrix<R, C>& matrix, std::uint32_t row,
                                      const Eigen::VectorXd& x) {
  Eigen::Matrix<double, R, 1> sum = Eigen::Matrix<double, R, 1>::Zero();
  for (std::size_t k = matrix.first[row]; k < matrix.first[row + std::size_t{1}]; ++k)
    sum.noalias() += matrix.block(k).lazyProduct(part_of<C>(x, matrix.columns[k]));
  return sum;
}

/// Where the blocks of a matrix stand, column by column.
struct ColumnPlaces {
  std::vector<std::size_t> first;   ///< [n_columns + 1] of a column's blocks
  std::vector<std::uint32_t> rows;  ///< [n_blocks] ascending in a column
  std::vector<std::size_t> places;  ///< [n_blocks] in the matrix
};

template <int R, int C>
ColumnPlaces find_columns(const BlockMatrix<R, C>& matrix) {
  ColumnPlaces by_column;
  by_column.first.assign(matrix.n_columns + std::size_t{1}, 0);
  by_column.rows.resize(matrix.n_blocks());
  by_column.places.resize(matrix.n_blocks());
  for (const std::uint32_t column : matrix.columns) ++by_column.first[column + std::size_t{1}];
  for (std::size_t i = 1; i < by_column.first.size(); ++i) by_column.first[i] += by_column.first[i - 1];
  std::vector<std::size_t> next(by_column.first.begin(), by_column.first.end() - 1);
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) {
    for (std::size_t k = matrix.first[row]; k < matrix.first[row + std::size_t{1}]; ++k) {
      const std::size_t place = next[matrix.columns[k]]++;
      by_column.rows[place] = row;
      by_column.places[place] = k;
    }
  }
  return by_column;
}

/// The transpose of a column of a matrix times a vector.
template <int R, int C>
Eigen::Matrix<double, C, 1> column_times(const BlockMatrix<R, C>& matrix, const ColumnPlaces& by_column,
                                         std::uint32_t column, const Eigen::VectorXd& x) {
  Eigen::Matrix<double, C, 1> sum = Eigen::Matrix<double, C, 1>::Zero();
  for (std::size_t k = by_column.first[column]; k < by_column.first[column + std::size_t{1}]; ++k)
    sum.noalias() +=
        matrix.block(by_column.places[k]).transpose().lazyProduct(part_of<R>(x, by_column.rows[k]));
  return sum;
}

}  // namespace contactsim
