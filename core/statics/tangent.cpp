// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/tangent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/parallel/ranks.hpp"
#include "core/statics/full_tangent.hpp"
#include "core/statics/multigrid_tangent.hpp"

namespace contactsim {

namespace {

/// A cube of more nodes takes a factor of MUMPS 0.7 seconds and more, multigrid a tenth of it (README); with
/// fewer the factor, which takes any stiffness, costs hardly more than what it is made of.
constexpr std::uint32_t most_nodes_of_factor = 5000;

/// Why equations take a factor: what turns, and rigid bodies that conditions do not wholly move, since these
/// join all that touches them, which multigrid would take for one group. Empty where multigrid does.
std::string why_factor(const StaticProblem& problem, const NodeGraph& graph) {
  if (problem.size() > 3 * Eigen::Index{graph.n_nodes()}) return "nodes of shells or beams turn";
  return problem.bodies().are_free() ? "a rigid body is not wholly held and prescribed" : "";
}

}  // namespace

std::int64_t Tangent::renew(const Eigen::VectorXd& increment, bool may_keep_elements) {
  constexpr double far = 0.1;
  const TangentBlocks::Update update = blocks_.update(increment, free_shares_, may_keep_elements);
  if (!update.exists) return update.n_evaluations;
  increment_ = increment;
  is_current_ = false;
  spring_size_ = update.spring_size;
  const double change = std::abs(spring_size_ - followed_spring_size_);
  if (update.has_new_elements || change > far * std::max(spring_size_, followed_spring_size_))
    follow_blocks(update.has_new_elements);
  return update.n_evaluations;
}

void Tangent::follow_blocks(bool has_new_elements) {
  follow(increment_, has_new_elements);
  is_current_ = true;
  followed_spring_size_ = spring_size_;
}

bool Tangent::catch_up() {
  if (is_current_) return false;
  follow_blocks(false);
  return true;
}

LinearSolverChoice choose_linear_solver(const StaticProblem& problem, const NodeGraph& graph,
                                        LinearSolver asked) {
  if (asked == LinearSolver::direct) return {asked, true, ""};
  if (asked == LinearSolver::distributed) {
    if (problem.ranks().are_several()) return {asked, true, ""};
    return {LinearSolver::direct, false, "the run is on one rank"};
  }
  if (const std::string reason = why_factor(problem, graph); !reason.empty())
    return {LinearSolver::direct, asked == LinearSolver::automatic, reason};
  if (asked == LinearSolver::multigrid) return {asked, true, ""};
  const bool is_large = graph.n_nodes() > most_nodes_of_factor;
  return {is_large ? LinearSolver::multigrid : LinearSolver::direct, true,
          fmt::format("there are {} {} nodes", is_large ? "more than" : "at most", most_nodes_of_factor)};
}

std::unique_ptr<Tangent> make_tangent(StaticProblem& problem, const NodeGraph& graph,
                                      const FullTangentSettings& settings) {
  const LinearSolver solver = choose_linear_solver(problem, graph, settings.linear_solver).solver;
  if (solver == LinearSolver::multigrid) return std::make_unique<MultigridTangent>(problem, graph, settings);
  return std::make_unique<FullTangent>(problem, graph, settings, solver == LinearSolver::distributed);
}

}  // namespace contactsim
