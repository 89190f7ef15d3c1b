// SPDX-License-Identifier: BSD-3-Clause
// Elements that die between load steps.
#include <algorithm>

#include "core/dynamics/state_motion.hpp"
#include "core/statics/static_problem.hpp"

namespace contactsim {

/// Has nodes without living elements stay where they are: nothing resists what loads them.
void StaticProblem::hold_nodes() {
  const auto by_node = [](const FreeDirections& a, const FreeDirections& b) { return a.node < b.node; };
  const auto hold = [&](std::vector<FreeDirections>& free) {
    std::ranges::sort(free, by_node);
    std::vector<FreeDirections> others;
    for (const NodeIndex node : lifeless_) {
      const FreeDirections held{node, Eigen::Matrix3d::Zero()};
      const auto known = std::ranges::lower_bound(free, held, by_node);
      if (known != free.end() && known->node == node) {
        *known = held;
      } else {
        others.push_back(held);
      }
    }
    free.insert(free.end(), others.begin(), others.end());
  };
  if (lifeless_.empty()) return;
  hold(free_);
  if (state_.rotations.exist()) hold(free_rotations_);
}

/// What the forces of the start leave over.
Eigen::VectorXd StaticProblem::unbalanced_at_start() const {
  Eigen::VectorXd unbalanced = all_forces_of_start();
  if (const double share = share_held(time_); share > 0.0) unbalanced -= share * held_;
  project(unbalanced);
  return unbalanced;
}

void StaticProblem::note_deaths(std::vector<NodeIndex> lifeless) {
  lifeless_ = std::move(lifeless);
  has_deaths_ = true;
  remember();
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, n_mesh_ / 3);
  Motion motion{state_.time, state_.dt, state_.coordinates, still};
  if (state_.rotations.exist()) motion.angular_velocity = &still;
  set_forces_of_mesh(motion);
  recall_elements();
  hold_nodes();
}

void StaticProblem::undo_deaths(std::vector<NodeIndex> lifeless, bool has_deaths) {
  lifeless_ = std::move(lifeless);
  has_deaths_ = has_deaths;
}

}  // namespace contactsim
