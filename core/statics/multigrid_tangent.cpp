// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid_tangent.hpp"

#include "core/statics/multigrid/rigid_modes.hpp"

namespace contactsim {

MultigridTangent::MultigridTangent(StaticProblem& problem, const NodeGraph& graph,
                                   const FullTangentSettings& settings)
    : problem_(problem), settings_(settings), blocks_(problem, graph) {}

Modes MultigridTangent::rigid_modes(const Eigen::VectorXd& increment) const {
  Modes modes = make_rigid_modes(problem_.coordinates_at(increment));
  for (Eigen::Index i = 0; i < modes.cols(); ++i) {
    Eigen::VectorXd mode = modes.col(i);
    problem_.project(mode);
    modes.col(i) = mode;
  }
  return modes;
}

std::int64_t MultigridTangent::renew(const Eigen::VectorXd& increment, bool /*may_keep_elements*/) {
  const std::int64_t n_evaluations = blocks_.renew(increment);
  if (n_evaluations == 0) return 0;
  largest_ = blocks_.largest();
  blocks_.steady(free_shares_);
  blocks_.join(blocks_of(problem_.contact_springs()));
  multigrid_.reset();
  matrix_ = blocks_.take_symmetric(settings_.tangent_diagonal_scale);
  multigrid_.emplace(matrix_, rigid_modes(increment));
  is_negative_ = false;
  return n_evaluations;
}

/// Ends at a direction of negative stiffness with what has been found before it, or with the steepest one.
void MultigridTangent::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  constexpr double tolerance = 1e-3;
  constexpr int max_iterations = 500;
  Eigen::VectorXd left = residual, product, step;
  const double target = tolerance * residual.norm();
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(residual.size());
  double last = 1.0;  // step . left
  z.setZero(residual.size());
  for (int i = 0; i < max_iterations && left.norm() > target; ++i) {
    multigrid_->apply(left, step);
    const double now = step.dot(left);
    direction = step + (i == 0 ? 0.0 : now / last) * direction;
    last = now;
    multiply(matrix_, direction, product);
    const double curvature = direction.dot(product);
    if (!(curvature > 0.0)) {
      is_negative_ = is_negative_ || curvature < 0.0;
      if (i == 0) z = direction;
      break;
    }
    ++n_iterations_;
    const double way = now / curvature;
    z += way * direction;
    left -= way * product;
  }
  problem_.project(z);
}

}  // namespace contactsim
