// SPDX-License-Identifier: BSD-3-Clause
// Elements that die between load steps.
#include <utility>

#include "core/dynamics/state_motion.hpp"
#include "core/statics/static_problem.hpp"

namespace contactsim {

/// What the forces of the start leave over.
Eigen::VectorXd StaticProblem::unbalanced_at_start() const {
  Eigen::VectorXd unbalanced = forces().all_at_start();
  taken_over_.take_off(taken_over_.share(start_.time()), unbalanced);
  project(unbalanced);
  return unbalanced;
}

void StaticProblem::note_deaths(std::vector<NodeIndex> lifeless) {
  held_.set_lifeless(std::move(lifeless));
  has_deaths_ = true;
  start_.remember(state_);
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, state_.coordinates.cols());
  Motion motion{state_.time, state_.dt, state_.coordinates, still};
  if (state_.rotations.exist()) motion.angular_velocity = &still;
  set_forces_of_mesh(motion);
  start_.restore_elements(state_);
  held_.hold_lifeless();
}

void StaticProblem::undo_deaths(std::vector<NodeIndex> lifeless, bool has_deaths) {
  held_.set_lifeless(std::move(lifeless));
  has_deaths_ = has_deaths;
}

}  // namespace contactsim
