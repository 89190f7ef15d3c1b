// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/body_blocks.hpp"
#include "core/statics/tangent_probe.hpp"

namespace contactsim {

/// The inverse of each node's own stiffness, 3 x 3 or 6 x 6, and of each rigid body's, 6 x 6: for compact
/// solids, of any size. Sierra calls it the nodal preconditioner BLOCK.
class NodalBlocks final : public Preconditioner {
 public:
  /// All must outlive it.
  NodalBlocks(StaticProblem& problem, const NodeGraph& graph);

  /// Finds the blocks at an increment of the step; those before stay where it cannot be evaluated. Returns
  /// the evaluations of the residual.
  std::int64_t renew(const Eigen::VectorXd& increment);

  /// The largest stiffness of a node against moving [force/length].
  double largest() const { return largest_; }

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;

 private:
  void invert(BodyBlocks& bodies);

  StaticProblem& problem_;
  TangentProbe probe_;
  Eigen::Index per_node_;
  double largest_ = 0.0;      // of displacements, without contact [force/length]
  Eigen::MatrixXd inverses_;  // [per_node x per_node n_nodes]
  std::vector<BodyBlocks::Block> body_inverses_;
};

}  // namespace contactsim
