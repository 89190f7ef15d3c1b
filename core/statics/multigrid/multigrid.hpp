// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/equilibrium.hpp"
#include "core/statics/multigrid/coarsest_grid.hpp"
#include "core/statics/multigrid/prolongator.hpp"

namespace contactsim {

/// A level of grids: how its equations are smoothed, and what the next level moves of it.
template <int N>
struct GridLevel {
  Chebyshev<N> smoother;
  BlockMatrix<N, 6> prolongator;                         ///< without columns where there is no next level
  ColumnPlaces by_column;                                ///< of the prolongator
  RowShare columns;                                      ///< of it that are worked out here
  mutable Eigen::VectorXd left, coarse_right, coarse_x;  ///< of the current cycle
};

/// One V-cycle of smoothed aggregation: near the inverse of a stiffness at a cost that grows with its size
/// alone. Symmetric, and positive where the stiffness is. The same bits for any number of threads and ranks.
/// Source: Vanek, Mandel and Brezina, Computing 56 (1996) 179-196.
class Multigrid final : public Preconditioner {
 public:
  /// Sets up the levels. All ranks call it, and apply(), alike: they share the products of large levels.
  ///   matrix  symmetric, must outlive it; rows of nodes without elements are empty
  ///   modes   [3 n_rows x 6] motions that cost next to no energy, 0 along held directions
  ///   ranks   must outlive it
  Multigrid(const BlockMatrix<3, 3>& matrix, const Modes& modes, Ranks& ranks = one_rank());

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;

  std::size_t n_levels() const { return 1 + matrices_.size(); }
  /// What the second level moves of the nodes, and its coefficients of the modes.
  const BlockMatrix<3, 6>& prolongator() const { return finest_.prolongator; }
  const Modes& coarse_modes() const { return coarse_modes_; }

 private:
  void cycle(std::size_t level, const Eigen::VectorXd& right, Eigen::VectorXd& x) const;

  const BlockMatrix<3, 3>& matrix_;
  GridLevel<3> finest_;
  Modes coarse_modes_;
  std::vector<GridLevel<6>> coarser_;
  std::vector<BlockMatrix<6, 6>> matrices_;  // of the coarser levels and the coarsest
  CoarsestGrid coarsest_;
};

}  // namespace contactsim
