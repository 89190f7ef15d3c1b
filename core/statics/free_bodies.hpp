// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/statics/node_graph.hpp"
#include "core/statics/static_problem.hpp"

namespace contactsim {

/// Bodies, which are what elements and rigid bodies join, that conditions leave some rigid motion.
struct FreeBodies {
  /// [n_nodes] What share of their stiffness nodes need to the ground for a factor: only contact and ties may
  /// hold these bodies, and the stiffness of their elements has no inverse. Together they come to a hundredth
  /// of what the body resists being stretched with, of bodies that stabilization holds to that much less.
  /// 0 of other nodes. Of nodes that rigid bodies have of their own shares of the largest stiffness of any
  /// node [1].
  std::vector<double> shares;
  std::vector<std::uint32_t> rigid;  ///< the rigid bodies among them
  bool are_any = false;
};

/// Finds them.
///   problem        at the begin of a step
///   coordinates    [3 x n_nodes] [length]
///   stabilization  of contact; its share is 0 where there is none
FreeBodies find_free_bodies(const StaticProblem& problem, const NodeGraph& graph,
                            const Eigen::Matrix3Xd& coordinates, const Stabilization& stabilization);

}  // namespace contactsim
