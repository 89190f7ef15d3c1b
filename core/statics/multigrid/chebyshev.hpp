// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "core/statics/multigrid/block_matrix.hpp"
#include "core/statics/multigrid/row_share.hpp"
#include "core/statics/positive_inverse.hpp"

namespace contactsim {

/// Takes the part of an error out that neighbours do not share, by Chebyshev's polynomial of second degree in
/// D^-1 A over the upper nine tenths of its eigenvalues; D are the blocks on the diagonal of A. A symmetric
/// operator whose rows are worked out one by one in the order of storage: sweeps by Gauss and Seidel over
/// colours, whose rows lie apart in memory, took five times as long.
/// Source: Adams, Brezina, Hu and Tuminaro, J. Comput. Phys. 188 (2003) 593-610, algorithm 1.
template <int N>
class Chebyshev {
 public:
  Chebyshev() = default;
  /// Of a symmetric matrix.
  ///   rows  of it that are worked out here
  Chebyshev(const BlockMatrix<N, N>& matrix, RowShare rows)
      : rows_(std::move(rows)), inverses_(matrix.n_rows()) {
    parallel_for(matrix.n_rows(), threads_for(10 * std::size_t{matrix.n_rows()}), [&](std::uint32_t row) {
      inverses_[row].setZero();
      if (!matrix.columns_of(row).empty())
        inverses_[row] = positive_inverse<N>(matrix.block(matrix.place_of(row, row)));
    });
    estimate_largest(matrix);
  }

  /// The inverse of a block on the diagonal.
  const Eigen::Matrix<double, N, N>& inverse(std::uint32_t row) const { return inverses_[row]; }
  /// The largest eigenvalue of D^-1 A, some percent too small.
  double largest() const { return largest_; }

  const RowShare& rows() const { return rows_; }

  /// Improves x towards A x = right.
  ///   is_zero  whether x is 0, which saves a product
  void smooth(const BlockMatrix<N, N>& matrix, const Eigen::VectorXd& right, bool is_zero,
              Eigen::VectorXd& x) const {
    constexpr int degree = 2;
    constexpr double margin = 1.1, lowest = 0.1;  // of the largest eigenvalue
    const double centre = 0.5 * (margin + lowest) * largest_, radius = 0.5 * (margin - lowest) * largest_;
    step_.setZero(x.size());
    double last = 0.0;  // ratio of the polynomials of two degrees
    for (int i = 0; i < degree; ++i) {
      const double ratio = i == 0 ? radius / centre : 1.0 / (2.0 * centre / radius - last);
      const double keep = ratio * last, add = i == 0 ? 1.0 / centre : 2.0 * ratio / radius;
      last = ratio;
      const bool has_product = i > 0 || !is_zero;
      const auto improve = [&](std::uint32_t row) {
        Part left = part_of<N>(right, row);
        if (has_product) left -= row_times(matrix, row, x);
        part_of<N>(step_, row) = keep * part_of<N>(step_, row) + add * inverses_[row].lazyProduct(left);
      };
      if (!has_product) {  // less work than to tell each other
        parallel_for(matrix.n_rows(), threads_for(matrix.n_blocks()), improve);
        x += step_;
        continue;
      }
      rows_.for_rows(improve);
      rows_.template part<N>(x) += rows_.template part<N>(step_);
      rows_.template gather<N>(x);
    }
  }

 private:
  using Part = Eigen::Matrix<double, N, 1>;

  /// The power method from a fixed vector that has something of all eigenvectors.
  void estimate_largest(const BlockMatrix<N, N>& matrix) {
    constexpr int n_iterations = 12;
    Eigen::VectorXd x(Eigen::Index{N} * matrix.n_rows()), y(x.size());
    std::uint32_t random = 1;
    for (double& value : x) {
      random = random * 1664525U + 1013904223U;  // Numerical Recipes' generator
      value = static_cast<double>(random) / 4294967296.0 - 0.5;
    }
    for (int i = 0; i < n_iterations; ++i) {
      rows_.for_rows([&](std::uint32_t row) {
        const Part product = row_times(matrix, row, x);
        part_of<N>(y, row) = inverses_[row].lazyProduct(product);
      });
      rows_.template gather<N>(y);
      const double size = y.norm();
      if (!(size > 0.0)) return;
      largest_ = size / x.norm();
      x = y / size;
    }
  }

  RowShare rows_;
  std::vector<Eigen::Matrix<double, N, N>> inverses_;  // [n_rows]
  double largest_ = 1.0;
  mutable Eigen::VectorXd step_;
};

}  // namespace contactsim
