// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/statics/multigrid/multigrid.hpp"
#include "core/statics/tangent.hpp"
#include "core/statics/tangent_blocks.hpp"

namespace contactsim {

/// The inverse of the stiffness of solids to a thousandth, with contact to a hundredth, by conjugate
/// gradients on its symmetric part with a V-cycle of multigrid, or by minimal residuals with what friction that
/// slides adds: for solids whose factor takes too long or too much memory. Newton's steps by it are inexact ones. Source: Dembo, Eisenstat and Steihaug, SIAM J. Numer.
/// Anal. 19 (1982) 400-408.
class MultigridTangent final : public Tangent {
 public:
  /// All must outlive it. Precondition: nodes do not turn.
  MultigridTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings);

  std::int64_t renew(const Eigen::VectorXd& increment, bool may_keep_elements = false) override;
  void set_free(std::vector<double> shares) override { free_shares_ = std::move(shares); }
  double largest() const override { return blocks_.largest(); }
  bool exists() const override { return multigrid_.has_value(); }
  /// 1 when conjugate gradients have met a direction of negative stiffness since renew().
  std::int64_t n_negative() const override { return is_negative_ ? 1 : 0; }
  std::int64_t n_iterations() const override { return n_iterations_; }

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;

 private:
  Modes rigid_modes(const Eigen::VectorXd& increment) const;

  StaticProblem& problem_;
  const FullTangentSettings& settings_;
  TangentBlocks blocks_;
  std::vector<double> free_shares_;  // [n_nodes], or empty [1]
  BlockMatrix<3, 3> matrix_;
  std::optional<Multigrid> multigrid_;  // of the matrix
  mutable bool is_negative_ = false;
  mutable std::int64_t n_iterations_ = 0;
};

}  // namespace contactsim
