// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/multigrid.hpp"

namespace contactsim {

namespace {

/// The coarsest level has not more rows of blocks: a dense factor of 900 unknowns takes a tenth of a second.
constexpr std::uint32_t coarsest_size = 150;
/// What joins nodes strongly on the finest level, half as much on each coarser one. Source: Vanek, Mandel and
/// Brezina (1996), section 5.
constexpr double finest_threshold = 0.08;

/// Directions that no column of a group moves get a stiffness, so that the matrix is not singular by them.
void hold_empty_columns(BlockMatrix<6, 6>& matrix) {
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) {
    auto own = matrix.block(matrix.place_of(row, row));
    const double largest = own.diagonal().maxCoeff();
    for (Eigen::Index i = 0; i < 6; ++i) {
      if (own(i, i) == 0.0) own(i, i) = largest > 0.0 ? largest : 1.0;
    }
  }
}

/// Makes a level, and the stiffness and the modes of the next one. Returns false when nothing joins its
/// nodes.
template <int N>
bool coarsen(const BlockMatrix<N, N>& matrix, double threshold, Ranks& ranks, Modes& modes,
             GridLevel<N>& level, BlockMatrix<6, 6>& coarse) {
  level.smoother = Chebyshev<N>(matrix, RowShare(matrix.first, ranks));
  const Aggregates groups = aggregate(matrix.first, matrix.columns, find_strengths(matrix, threshold));
  if (groups.n == 0) return false;
  GroupColumns<N> columns = make_group_columns<N>(groups, modes);
  level.prolongator = smooth_columns(matrix, level.smoother, groups, columns);
  level.by_column = find_columns(level.prolongator);
  level.columns = RowShare(level.by_column.first, ranks);
  coarse = galerkin_product(matrix, level.prolongator, level.by_column);
  hold_empty_columns(coarse);
  modes = std::move(columns.coarse_modes);
  return true;
}

Eigen::MatrixXd to_dense(const BlockMatrix<6, 6>& matrix) {
  const Eigen::Index size = 6 * Eigen::Index{matrix.n_rows()};
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) {
    for (std::size_t k = matrix.first[row]; k < matrix.first[row + std::size_t{1}]; ++k)
      dense.block<6, 6>(6 * Eigen::Index{row}, 6 * Eigen::Index{matrix.columns[k]}) = matrix.block(k);
  }
  return dense;
}

/// Smooths, has the next level correct what is left, and smooths again.
///   solve_coarse(right, x)  sets x to the correction
template <int N, class Solve>
void correct(const BlockMatrix<N, N>& matrix, const GridLevel<N>& level, const Eigen::VectorXd& right,
             Eigen::VectorXd& x, const Solve& solve_coarse) {
  x.setZero(right.size());
  level.smoother.smooth(matrix, right, true, x);
  if (level.prolongator.n_columns > 0) {
    const RowShare& rows = level.smoother.rows();
    level.left.resize(right.size());
    rows.for_rows([&](std::uint32_t row) {
      part_of<N>(level.left, row) = part_of<N>(right, row) - row_times(matrix, row, x);
    });
    rows.template gather<N>(level.left);
    level.coarse_right.resize(6 * Eigen::Index{level.prolongator.n_columns});
    level.columns.for_rows([&](std::uint32_t column) {
      part_of<6>(level.coarse_right, column) =
          column_times(level.prolongator, level.by_column, column, level.left);
    });
    level.columns.template gather<6>(level.coarse_right);
    solve_coarse(level.coarse_right, level.coarse_x);
    rows.for_rows(
        [&](std::uint32_t row) { part_of<N>(x, row) += row_times(level.prolongator, row, level.coarse_x); });
    rows.template gather<N>(x);
  }
  level.smoother.smooth(matrix, right, false, x);
}

}  // namespace

Multigrid::Multigrid(const BlockMatrix<3, 3>& matrix, const Modes& modes, Ranks& ranks) : matrix_(matrix) {
  Modes of_level = modes;
  BlockMatrix<6, 6> coarse;
  double threshold = finest_threshold;
  if (!coarsen(matrix_, threshold, ranks, of_level, finest_, coarse)) return;
  coarse_modes_ = of_level;
  matrices_.push_back(std::move(coarse));
  while (matrices_.back().n_rows() > coarsest_size) {
    threshold *= 0.5;
    coarser_.emplace_back();
    if (!coarsen(matrices_.back(), threshold, ranks, of_level, coarser_.back(), coarse)) return;
    matrices_.push_back(std::move(coarse));
  }
  coarsest_ = CoarsestGrid(to_dense(matrices_.back()));
}

void Multigrid::cycle(std::size_t level, const Eigen::VectorXd& right, Eigen::VectorXd& x) const {
  if (level < coarser_.size()) {
    correct(matrices_[level], coarser_[level], right, x,
            [&](const Eigen::VectorXd& coarse_right, Eigen::VectorXd& coarse_x) {
              cycle(level + 1, coarse_right, coarse_x);
            });
  } else {
    x = coarsest_.solve(right);
  }
}

void Multigrid::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  correct(matrix_, finest_, residual, z,
          [&](const Eigen::VectorXd& right, Eigen::VectorXd& x) { cycle(0, right, x); });
}

}  // namespace contactsim
