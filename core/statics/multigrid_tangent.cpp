// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid_tangent.hpp"

#include "core/statics/multigrid/rigid_modes.hpp"

namespace contactsim {

MultigridTangent::MultigridTangent(StaticProblem& problem, const NodeGraph& graph,
                                   const FullTangentSettings& settings)
    : problem_(problem), blocks_(problem, graph, settings.tangent_diagonal_scale) {}

Modes MultigridTangent::rigid_modes() const {
  Modes modes = make_rigid_modes(problem_.coordinates_at(at_));
  for (Eigen::Index i = 0; i < modes.cols(); ++i) {
    Eigen::VectorXd mode = modes.col(i);
    problem_.project(mode);
    modes.col(i) = mode;
  }
  return modes;
}

std::int64_t MultigridTangent::renew(const Eigen::VectorXd& increment, bool may_keep_elements) {
  const TangentBlocks::Update update = blocks_.update(increment, free_shares_, may_keep_elements);
  if (!update.exists) return update.n_evaluations;
  at_ = increment;
  is_current_ = false;
  spring_size_ = update.spring_size;
  if (update.has_new_elements || has_changed_far(spring_size_of_levels_, spring_size_)) set_up();
  return update.n_evaluations;
}

void MultigridTangent::set_up() {
  multigrid_.reset();
  matrix_ = blocks_.take_symmetric(problem_.contact() != nullptr);
  multigrid_.emplace(matrix_, rigid_modes());
  is_current_ = true;
  spring_size_of_levels_ = spring_size_;
}

bool MultigridTangent::catch_up() {
  if (is_current_) return false;
  set_up();
  return true;
}

void MultigridTangent::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  multigrid_->apply(residual, z);
  problem_.project(z);
}

}  // namespace contactsim
