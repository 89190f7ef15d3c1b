// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/tangent.hpp"

#include "core/statics/full_tangent.hpp"
#include "core/statics/multigrid_tangent.hpp"

namespace contactsim {

namespace {

/// A cube of more nodes takes a factor of MUMPS 0.7 seconds and more, multigrid a tenth of it (README); with
/// fewer the factor, which takes any stiffness, costs hardly more than what it is made of.
constexpr std::uint32_t most_nodes_of_factor = 5000;

/// What turns, and rigid bodies that conditions do not wholly move: these join all that touches them, which
/// multigrid would take for one group.
bool needs_factor(const StaticProblem& problem, const NodeGraph& graph) {
  return problem.size() > 3 * Eigen::Index{graph.n_nodes()} || problem.bodies().are_free();
}

}  // namespace

LinearSolver choose_linear_solver(const StaticProblem& problem, const NodeGraph& graph) {
  return needs_factor(problem, graph) || graph.n_nodes() <= most_nodes_of_factor ? LinearSolver::direct
                                                                                 : LinearSolver::multigrid;
}

std::unique_ptr<Tangent> make_tangent(StaticProblem& problem, const NodeGraph& graph,
                                      const FullTangentSettings& settings) {
  LinearSolver solver = settings.linear_solver;
  if (solver == LinearSolver::automatic || needs_factor(problem, graph))
    solver = choose_linear_solver(problem, graph);
  if (solver == LinearSolver::multigrid) return std::make_unique<MultigridTangent>(problem, graph, settings);
  return std::make_unique<FullTangent>(problem, graph, settings);
}

}  // namespace contactsim
