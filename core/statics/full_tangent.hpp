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

  /// Makes the factor at an increment of the step; the one before stays where it cannot be evaluated. Returns
  /// the evaluations of the residual.
  std::int64_t renew(const Eigen::VectorXd& increment);
  bool exists() const { return exists_; }
  /// Directions along which the stiffness of solids is negative: of a body that has buckled; 0 where nodes
  /// turn, whose factor does not tell.
  std::int64_t n_negative() const { return exists_ ? factor_->n_negative() : 0; }

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;

 private:
  double* block_of(std::uint32_t node, std::uint32_t neighbour);
  void hold_directions();
  void steady_rotations();
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
  std::vector<int> numbers_;         // [size] of the unknowns in the matrix, -1 of those without stiffness
  std::vector<std::size_t> places_;  // [n] of the matrix's unknowns in vectors
  std::unique_ptr<SparseFactor> factor_;
  bool exists_ = false;
};

}  // namespace contactsim
