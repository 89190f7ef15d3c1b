// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/definition/solver.hpp"
#include "core/statics/sparse_factor.hpp"
#include "core/statics/tangent_probe.hpp"

namespace contactsim {

/// A factor of the whole stiffness: for slender, thin and nearly incompressible bodies, where nodal blocks
/// take thousands of iterations. Of solids it is L D L^T of the symmetric part, which following loads alone
/// spoil; where nodes turn, L U of the true one: shells and beams that turn by a tenth in a step have an
/// unsymmetric one, and by its symmetric part Newton's steps do not converge.
class FullTangent final : public Preconditioner {
 public:
  /// All must outlive it.
  FullTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings);

  /// Makes the factor at an increment of the step; the one before stays where it cannot be evaluated. Where
  /// contact has other springs than in the last factor, these alone are made anew, if that is wanted. Returns
  /// the evaluations of the residual.
  std::int64_t renew(const Eigen::VectorXd& increment, bool may_keep_elements = false);
  /// The largest stiffness of a node against moving, without contact [force/length].
  double largest() const { return largest_; }
  bool exists() const { return exists_; }
  /// Shares of their stiffness that nodes get to the ground in the factor [n_nodes]: find_free_bodies().
  void set_free(std::vector<double> shares) { free_shares_ = std::move(shares); }
  /// Directions along which the stiffness of solids is negative: of a body that has buckled; 0 where nodes
  /// turn, whose factor does not tell.
  std::int64_t n_negative() const { return exists_ ? factor_->n_negative() : 0; }

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;

 private:
  double* block_of(std::uint32_t node, std::uint32_t neighbour);
  void hold_directions();
  void steady_rotations();
  void steady_free_bodies();
  void find_largest();
  std::int64_t probe_elements(const Eigen::VectorXd& increment);
  void number_unknowns();
  SparseFactor::Matrix assemble();
  bool is_symmetric() const { return per_node_ == 3; }

  StaticProblem& problem_;
  const NodeGraph& graph_;
  const FullTangentSettings& settings_;
  TangentProbe probe_;
  std::size_t per_node_;
  std::vector<std::size_t> first_;  // [n_nodes + 1] of a node's blocks, over its neighbours
  // Of a node's unknowns, the rows of a neighbour [n_pairs x per_node x per_node].
  std::vector<double> columns_;
  std::vector<double> free_shares_;  // [n_nodes], or empty [1]
  std::vector<ContactSpring> springs_;  // of contact
  double spring_size_ = 0.0;         // what tells whether they have changed
  double largest_ = 0.0;
  std::vector<int> numbers_;         // [size] of the unknowns in the matrix, -1 of those without stiffness
  std::vector<std::size_t> places_;  // [n] of the matrix's unknowns in vectors
  std::unique_ptr<SparseFactor> factor_;
  bool exists_ = false;
};

}  // namespace contactsim
