// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/definition/solver.hpp"
#include "core/statics/node_graph.hpp"
#include "core/statics/sparse_factor.hpp"
#include "core/statics/tangent_blocks.hpp"

namespace contactsim {

/// Near the inverse of the whole stiffness, for Newton's steps. It is kept where contact has other springs,
/// until these have changed far or catch_up(): contact changes a few in every iteration.
class Tangent : public Preconditioner {
 public:
  /// Finds the stiffness at an increment of the step; the one before stays where it cannot be evaluated.
  /// Returns the evaluations of the residual.
  ///   may_keep_elements  the springs of contact alone, which apply() has from catch_up() on, or at once
  ///   where
  ///                      they have changed far
  std::int64_t renew(const Eigen::VectorXd& increment, bool may_keep_elements = false);
  bool catch_up() final;
  const Eigen::VectorXd* ground() const final {
    return blocks_.ground().size() > 0 ? &blocks_.ground() : nullptr;
  }
  /// Shares of their stiffness that nodes get to the ground [n_nodes]: find_free_bodies().
  void set_free(std::vector<double> shares) { free_shares_ = std::move(shares); }
  /// The largest stiffness of a node against moving, without contact [force/length].
  double largest() const { return blocks_.largest(); }
  virtual bool exists() const = 0;
  /// Directions along which the stiffness is known to be negative: of a body that has buckled.
  virtual std::int64_t n_negative() const { return 0; }
  /// Of the last factor; absent without one.
  virtual std::optional<FactorMemory> factor_memory() const { return std::nullopt; }

 protected:
  Tangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings)
      : problem_(problem), blocks_(problem, graph, settings.tangent_diagonal_scale) {}

  StaticProblem& problem_;
  TangentBlocks blocks_;

 private:
  /// Has apply() follow the blocks.
  ///   increment         that they are of
  ///   has_new_elements  since the last time
  virtual void follow(const Eigen::VectorXd& increment, bool has_new_elements) = 0;
  void follow_blocks(bool has_new_elements);

  std::vector<double> free_shares_;  // [n_nodes], or empty [1]
  Eigen::VectorXd increment_;        // of the last renew()
  bool is_current_ = false;          // apply() has the blocks of now
  double spring_size_ = 0.0,
         followed_spring_size_ = 0.0;  // TangentBlocks::Update::spring_size, of now, of apply()
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
