// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/statics/sparse_factor.hpp"
#include "core/statics/tangent.hpp"
#include "core/statics/tangent_blocks.hpp"

namespace contactsim {

/// A factor of the whole stiffness: for slender, thin and nearly incompressible bodies, where nodal blocks
/// take thousands of iterations. Of solids it is L D L^T of the symmetric part, which following loads alone
/// spoil; where nodes turn, L U of the true one: shells and beams that turn by a tenth in a step have an
/// unsymmetric one, and by its symmetric part Newton's steps do not converge.
///
/// A factor is kept until catch_up(): contact changes a few springs in every iteration, and a factor costs as
/// much as a hundred solutions with it.
class FullTangent final : public Tangent {
 public:
  /// All must outlive it.
  FullTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings);

  std::int64_t renew(const Eigen::VectorXd& increment, bool may_keep_elements = false) override;
  void set_free(std::vector<double> shares) override { free_shares_ = std::move(shares); }
  double largest() const override { return blocks_.largest(); }
  bool exists() const override { return exists_; }
  /// 0 where nodes turn, whose factor does not tell; of the last factor.
  std::int64_t n_negative() const override { return exists_ ? factor_->n_negative() : 0; }

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;
  bool catch_up() override;
  const Eigen::VectorXd* ground() const override { return ground_of(blocks_); }

 private:
  void number_unknowns();
  SparseFactor::Matrix assemble() const;
  bool is_symmetric() const { return blocks_.per_node() == 3; }
  void factorise();

  StaticProblem& problem_;
  const NodeGraph& graph_;
  TangentBlocks blocks_;
  std::vector<double> free_shares_;  // [n_nodes], or empty [1]
  std::vector<int> numbers_;         // [size] of the unknowns in the matrix, -1 of those without stiffness
  std::vector<std::size_t> places_;  // [n] of the matrix's unknowns in vectors
  std::unique_ptr<SparseFactor> factor_;
  bool exists_ = false;
  bool is_current_ = false;  // the factor is that of the blocks
  double spring_size_ = 0.0, spring_size_of_factor_ = 0.0;
};

}  // namespace contactsim
