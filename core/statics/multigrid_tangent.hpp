// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/statics/multigrid/multigrid.hpp"
#include "core/statics/tangent.hpp"
#include "core/statics/tangent_blocks.hpp"

namespace contactsim {

/// A V-cycle of multigrid on the symmetric part of the stiffness: for solids whose factor takes too long or
/// too much memory. It is kept until catch_up(), as a factor is.
class MultigridTangent final : public Tangent {
 public:
  /// All must outlive it. Precondition: nodes do not turn.
  MultigridTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings);

  std::int64_t renew(const Eigen::VectorXd& increment, bool may_keep_elements = false) override;
  void set_free(std::vector<double> shares) override { free_shares_ = std::move(shares); }
  double largest() const override { return blocks_.largest(); }
  bool exists() const override { return multigrid_.has_value(); }
  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;
  bool catch_up() override;
  const Eigen::VectorXd* ground() const override { return ground_of(blocks_); }

 private:
  Modes rigid_modes() const;
  void set_up();

  StaticProblem& problem_;
  TangentBlocks blocks_;
  std::vector<double> free_shares_;  // [n_nodes], or empty [1]
  BlockMatrix<3, 3> matrix_;
  std::optional<Multigrid> multigrid_;  // of the matrix
  bool is_current_ = false;             // the levels are those of the blocks
  double spring_size_ = 0.0, spring_size_of_levels_ = 0.0;
  Eigen::VectorXd at_;  // the increment of the last renew()
};

}  // namespace contactsim
