// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/multigrid/block_matrix.hpp"

namespace contactsim {

/// Which blocks a row of a matrix has and where they stand while the row is being made: one for a thread.
class RowPattern {
 public:
  explicit RowPattern(std::uint32_t n_columns) : place_(n_columns, none) {}

  void add(std::uint32_t column) {
    if (place_[column] != none) return;
    place_[column] = 0;
    columns_.push_back(column);
  }
  std::size_t size() const { return columns_.size(); }
  /// Writes the columns in ascending order.
  ///   first  place of the row's first block
  void write(std::size_t first, std::uint32_t* columns) {
    std::sort(columns_.begin(), columns_.end());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      place_[columns_[i]] = first + i;
      columns[first + i] = columns_[i];
    }
  }
  std::size_t place(std::uint32_t column) const { return place_[column]; }
  void clear() {
    for (const std::uint32_t column : columns_) place_[column] = none;
    columns_.clear();
  }

 private:
  static constexpr std::size_t none = SIZE_MAX;  // one word each: rows are made in the innermost loops
  std::vector<std::size_t> place_;
  std::vector<std::uint32_t> columns_;
};

/// A matrix whose blocks are sums of products. Every row is summed by one thread, in the order of the visit.
///   visit(row, take)  calls take(column, left, right) for every product left right that belongs to a block
///                     of the row
template <int R, int C, class Visit>
BlockMatrix<R, C> sum_products(std::uint32_t n_rows, std::uint32_t n_columns, const Visit& visit) {
  BlockMatrix<R, C> sum;
  sum.n_columns = n_columns;
  sum.first.assign(n_rows + std::size_t{1}, 0);
  // A row has tens of blocks of tens of products.
  const int n_threads = threads_for(100 * std::size_t{n_rows});
  parallel_for_ranges(n_rows, n_threads, [&](std::int64_t begin, std::int64_t end) {
    RowPattern pattern(n_columns);
    for (auto row = static_cast<std::uint32_t>(begin); row < end; ++row) {
      visit(row, [&](std::uint32_t column, const auto&, const auto&) { pattern.add(column); });
      sum.first[row + std::size_t{1}] = pattern.size();
      pattern.clear();
    }
  });
  for (std::size_t i = 1; i < sum.first.size(); ++i) sum.first[i] += sum.first[i - 1];
  sum.columns.resize(sum.first.back());
  sum.values.assign(sum.first.back() * BlockMatrix<R, C>::block_size, 0.0);
  parallel_for_ranges(n_rows, n_threads, [&](std::int64_t begin, std::int64_t end) {
    RowPattern pattern(n_columns);
    for (auto row = static_cast<std::uint32_t>(begin); row < end; ++row) {
      visit(row, [&](std::uint32_t column, const auto&, const auto&) { pattern.add(column); });
      pattern.write(sum.first[row], sum.columns.data());
      visit(row, [&](std::uint32_t column, const auto& left, const auto& right) {
        sum.block(pattern.place(column)).noalias() += left.lazyProduct(right);
      });
      pattern.clear();
    }
  });
  return sum;
}

/// P^T A P, the stiffness between the columns of a prolongator.
template <int N, int M>
BlockMatrix<M, M> galerkin_product(const BlockMatrix<N, N>& matrix, const BlockMatrix<N, M>& prolongator,
                                   const ColumnPlaces& by_column) {
  const auto visit_row = [](const auto& of, std::uint32_t row, const auto& take) {
    for (std::size_t k = of.first[row]; k < of.first[row + std::size_t{1}]; ++k)
      take(of.columns[k], of.block(k));
  };
  const auto half =
      sum_products<N, M>(matrix.n_rows(), prolongator.n_columns, [&](std::uint32_t row, const auto& take) {
        visit_row(matrix, row, [&](std::uint32_t middle, const auto& left) {
          visit_row(prolongator, middle,
                    [&](std::uint32_t column, const auto& right) { take(column, left, right); });
        });
      });
  return sum_products<M, M>(
      prolongator.n_columns, prolongator.n_columns, [&](std::uint32_t row, const auto& take) {
        for (std::size_t k = by_column.first[row]; k < by_column.first[row + std::size_t{1}]; ++k) {
          const auto left = prolongator.block(by_column.places[k]);
          visit_row(half, by_column.rows[k],
                    [&](std::uint32_t column, const auto& right) { take(column, left.transpose(), right); });
        }
      });
}

}  // namespace contactsim
