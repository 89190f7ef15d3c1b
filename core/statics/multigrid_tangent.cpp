// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid_tangent.hpp"

#include "core/statics/multigrid/rigid_modes.hpp"

namespace contactsim {

MultigridTangent::MultigridTangent(StaticProblem& problem, const NodeGraph& graph,
                                   const FullTangentSettings& settings)
    : Tangent(problem, graph, settings) {}

Modes MultigridTangent::rigid_modes(const Eigen::VectorXd& increment) const {
  Modes modes = make_rigid_modes(problem_.coordinates_at(increment));
  for (Eigen::Index i = 0; i < modes.cols(); ++i) {
    Eigen::VectorXd mode = modes.col(i);
    problem_.project(mode);
    modes.col(i) = mode;
  }
  return modes;
}

void MultigridTangent::follow(const Eigen::VectorXd& increment, bool /*has_new_elements*/) {
  multigrid_.reset();
  matrix_ = blocks_.take_symmetric(problem_.contact() != nullptr);
  multigrid_.emplace(matrix_, rigid_modes(increment), problem_.ranks());
}

void MultigridTangent::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  multigrid_->apply(residual, z);
  problem_.project(z);
}

}  // namespace contactsim
