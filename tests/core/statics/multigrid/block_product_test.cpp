// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/block_product.hpp"

#include "support/block_products.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::multiply;
using contactsim::test::multiply_transposed;

namespace {

/// Numbers in those blocks whose row and column have certain places.
template <int R, int C>
BlockMatrix<R, C> sparse_matrix(std::uint32_t n_rows, std::uint32_t n_columns) {
  BlockMatrix<R, C> matrix;
  matrix.n_columns = n_columns;
  matrix.first.push_back(0);
  for (std::uint32_t row = 0; row < n_rows; ++row) {
    for (std::uint32_t column = 0; column < n_columns; ++column) {
      if ((3 * row + 5 * column) % 4 == 1) continue;
      matrix.columns.push_back(column);
      for (int i = 0; i < R * C; ++i) matrix.values.push_back(std::sin(7.0 * row + 3.0 * column + i));
    }
    matrix.first.push_back(matrix.columns.size());
  }
  return matrix;
}

template <int R, int C>
Eigen::MatrixXd whole(const BlockMatrix<R, C>& matrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(R * matrix.n_rows(), C * matrix.n_columns);
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) {
    for (const std::uint32_t column : matrix.columns_of(row))
      dense.block<R, C>(R * row, C * column) = matrix.block(matrix.place_of(row, column));
  }
  return dense;
}

}  // namespace

TEST_CASE("products of block matrices are those of the whole ones", "[core][statics]") {
  const auto matrix = sparse_matrix<3, 3>(7, 7);
  const auto prolongator = sparse_matrix<3, 6>(7, 4);
  const ColumnPlaces by_column = find_columns(prolongator);
  const Eigen::MatrixXd a = whole(matrix), p = whole(prolongator);
  const auto coarse = galerkin_product(matrix, prolongator, by_column);
  CHECK((whole(coarse) - p.transpose() * a * p).norm() < 1e-13 * a.norm() * p.norm());

  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(21, -1.0, 2.0), right = x.head(24 - 3).reverse();
  Eigen::VectorXd y;
  multiply(matrix, x, y);
  CHECK((y - a * x).norm() < 1e-13 * a.norm());
  multiply_transposed(prolongator, by_column, right, y);
  CHECK((y - p.transpose() * right).norm() < 1e-13 * p.norm());
}
