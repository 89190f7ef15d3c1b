// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/base/optional_index.hpp"
#include "core/statics/sparse_factor.hpp"
#include "core/statics/tangent.hpp"
#include "core/statics/tangent_blocks.hpp"

namespace contactsim {

/// A factor of the whole stiffness: for slender, thin and nearly incompressible bodies, where nodal blocks
/// take thousands of iterations. Of solids it is L D L^T of the symmetric part, which following loads alone
/// spoil; where nodes turn, L U of the true one: shells and beams that turn by a tenth in a step have an
/// unsymmetric one, and by its symmetric part Newton's steps do not converge.
class FullTangent final : public Tangent {
 public:
  /// All must outlive it. Throws FileError where the factor is to be divided among ranks and cannot.
  ///   is_distributed  it is
  FullTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings,
              bool is_distributed = false);

  bool exists() const override { return exists_; }
  /// 0 where nodes turn, whose factor does not tell; of the last factor.
  std::int64_t n_negative() const override { return exists_ ? factor_->n_negative() : 0; }

  std::optional<FactorMemory> factor_memory() const override { return factor_->memory(); }

  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override;

 private:
  void follow(const Eigen::VectorXd& increment, bool has_new_elements) override;
  void number_unknowns();
  SparseFactor::Matrix assemble() const;
  bool is_symmetric() const { return blocks_.per_node() == 3; }

  const NodeGraph& graph_;
  /// [size] of the unknowns in the matrix; absent of those without stiffness
  std::vector<OptionalIndex<std::uint32_t>> numbers_;
  std::vector<std::size_t> places_;  // [n] of the matrix's unknowns in vectors
  std::unique_ptr<SparseFactor> factor_;
  bool exists_ = false;
};

}  // namespace contactsim
