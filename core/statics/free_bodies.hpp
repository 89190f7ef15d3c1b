// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/statics/node_graph.hpp"
#include "core/statics/static_problem.hpp"

namespace contactsim {

/// [n_nodes] What share of their stiffness the nodes of bodies, which are what elements and rigid bodies
/// join, need to the ground for a factor, where conditions alone leave some rigid motion: only contact and
/// ties may hold them, and the stiffness of their elements has no inverse. Together they come to a hundredth
/// of what the body resists being stretched with. 0 of other nodes. Of nodes that rigid bodies have of their
/// own shares of the largest stiffness of any node [1].
///   problem      at the begin of a step
///   coordinates  [3 x n_nodes] [length]
std::vector<double> find_free_bodies(const StaticProblem& problem, const NodeGraph& graph,
                                     const Eigen::Matrix3Xd& coordinates);

}  // namespace contactsim
