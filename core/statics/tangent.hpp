// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/definition/solver.hpp"
#include "core/statics/node_graph.hpp"
#include "core/statics/tangent_blocks.hpp"

namespace contactsim {

/// Near the inverse of the whole stiffness, for Newton's steps.
class Tangent : public Preconditioner {
 public:
  /// Finds the stiffness at an increment of the step; the one before stays where it cannot be evaluated.
  /// Returns the evaluations of the residual.
  ///   may_keep_elements  the springs of contact alone, which apply() has from catch_up() on, or at once
  ///   where
  ///                      they have changed far
  virtual std::int64_t renew(const Eigen::VectorXd& increment, bool may_keep_elements = false) = 0;
  /// Shares of their stiffness that nodes get to the ground [n_nodes]: find_free_bodies().
  virtual void set_free(std::vector<double> shares) = 0;
  /// The largest stiffness of a node against moving, without contact [force/length].
  virtual double largest() const = 0;
  virtual bool exists() const = 0;
  /// Directions along which the stiffness is known to be negative: of a body that has buckled.
  virtual std::int64_t n_negative() const { return 0; }

 protected:
  /// Whether springs are so different from those of apply() that it has to follow.
  ///   before, now  TangentBlocks::Update::spring_size
  static bool has_changed_far(double before, double now) {
    constexpr double far = 0.1;
    return std::abs(now - before) > far * std::max(now, before);
  }
  static const Eigen::VectorXd* ground_of(const TangentBlocks& blocks) {
    return blocks.ground().size() > 0 ? &blocks.ground() : nullptr;
  }
};

/// The equation solver of a run.
struct LinearSolverChoice {
  LinearSolver solver = LinearSolver::direct;  ///< never automatic
  bool is_asked_for = true;                    ///< by the deck, or left open by it
  std::string reason;                          ///< why it is this one; empty where the deck says so
};

/// The solver for what a deck asks for: a factor where nodes turn, or a rigid body is not wholly held and
/// prescribed, else as asked; left open, multigrid for solids of so many unknowns that a factor takes longer.
LinearSolverChoice choose_linear_solver(const StaticProblem& problem, const NodeGraph& graph,
                                        LinearSolver asked);

/// Makes the tangent of choose_linear_solver(). All must outlive it.
std::unique_ptr<Tangent> make_tangent(StaticProblem& problem, const NodeGraph& graph,
                                      const FullTangentSettings& settings);

}  // namespace contactsim
