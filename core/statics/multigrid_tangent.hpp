// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/statics/multigrid/multigrid.hpp"
#include "core/statics/tangent.hpp"
#include "core/statics/tangent_blocks.hpp"

namespace contactsim {

/// A V-cycle of multigrid on the symmetric part of the stiffness: for solids whose factor takes too long or
/// too much memory.
class MultigridTangent final : public Tangent {
 public:
  /// All must outlive it. Precondition: nodes do not turn.
  MultigridTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings);

  bool exists() const override { return multigrid_.has_value(); }
  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;

 private:
  void follow(const Eigen::VectorXd& increment, bool has_new_elements) override;
  Modes rigid_modes(const Eigen::VectorXd& increment) const;

  BlockMatrix<3, 3> matrix_;
  std::optional<Multigrid> multigrid_;  // of the matrix
};

}  // namespace contactsim
