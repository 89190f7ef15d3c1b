// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "core/statics/node_graph.hpp"
#include "core/statics/static_problem.hpp"

namespace contactsim {

/// The stiffness of all but contact by differences of residuals in which all nodes of a colour move at once:
/// exact for every element and material, with whatever its law does on the way from the start of the step.
/// That of contact, which no pattern of elements holds, is in StaticProblem::springs() afterwards.
/// Nodes of rigid bodies count as if they were free: StaticBodies::carriers() says by what they are moved.
class TangentProbe {
 public:
  /// All must outlive it.
  TangentProbe(StaticProblem& problem, const NodeGraph& graph, ColourDistance distance)
      : problem_(problem), colours_(colour_nodes(graph, distance)) {}

  /// Unknowns of a node: 3, or 6 with rotations.
  Eigen::Index unknowns_per_node() const { return problem_.size() / n_nodes(); }
  Eigen::Index n_nodes() const { return static_cast<Eigen::Index>(colours_.colour.size()); }
  /// Where an unknown of a node stands in vectors.
  Eigen::Index place(std::uint32_t node, Eigen::Index unknown) const {
    return (unknown / 3 * n_nodes() + static_cast<Eigen::Index>(node)) * 3 + unknown % 3;
  }

  /// Calls take(node, unknown, column) with the negative derivative of the residual along an unknown of every
  /// node of the mesh that has elements; of the column only what lies at the node, or with two_elements at
  /// its neighbours, is of that node. Returns the evaluations of the residual, 0 when there is none at the
  /// increment.
  using Take = std::function<void(std::uint32_t node, Eigen::Index unknown, const Eigen::VectorXd& column)>;
  std::int64_t differentiate(const Eigen::VectorXd& increment, const Take& take);

 private:
  StaticProblem& problem_;
  NodeColours colours_;
};

}  // namespace contactsim
