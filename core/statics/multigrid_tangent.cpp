// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid_tangent.hpp"

#include "core/statics/gmres.hpp"
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

std::int64_t MultigridTangent::renew(const Eigen::VectorXd& increment, bool may_keep_elements) {
  const TangentBlocks::Update update = blocks_.update(increment, free_shares_, may_keep_elements);
  if (!update.exists) return update.n_evaluations;
  multigrid_.reset();
  matrix_ = blocks_.take_symmetric(settings_.tangent_diagonal_scale, problem_.contact() != nullptr);
  multigrid_.emplace(matrix_, rigid_modes(increment));
  is_negative_ = false;
  return update.n_evaluations;
}

/// Ends at a direction of negative stiffness with what has been found before it, or with the steepest one.
void MultigridTangent::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  // With contact, whose faces part and meet, Newton's steps gain no more by a step than a tenth.
  const double tolerance = problem_.contact() != nullptr ? 1e-2 : 1e-3;
  const bool has_unsymmetric = blocks_.has_unsymmetric();
  const auto multiply_by_matrix = [&](const Eigen::VectorXd& direction, Eigen::VectorXd& product) {
    multiply(matrix_, direction, product);
    if (has_unsymmetric) blocks_.add_unsymmetric(direction, product);
  };
  const auto precondition = [&](const Eigen::VectorXd& left, Eigen::VectorXd& step) {
    multigrid_->apply(left, step);
  };
  // Minimal residuals keep a vector of each iteration.
  constexpr int most_by_gradients = 500, most_by_residuals = 60;
  const LinearSearch search =
      has_unsymmetric
          ? gmres(multiply_by_matrix, precondition, residual, tolerance, most_by_residuals, z)
          : conjugate_gradients(multiply_by_matrix, precondition, residual, tolerance, most_by_gradients, z);
  n_iterations_ += search.n_iterations;
  is_negative_ = is_negative_ || search.end == LinearSearch::End::negative;
  problem_.project(z);
}

}  // namespace contactsim
