// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/full_tangent.hpp"

#include <utility>

namespace contactsim {

FullTangent::FullTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings,
                         bool is_distributed)
    : Tangent(problem, graph, settings),
      graph_(graph),
      factor_(is_distributed ? make_distributed_factor(is_symmetric(), problem.ranks())
                             : make_sparse_factor(is_symmetric())) {}

void FullTangent::number_unknowns() {
  numbers_.assign(static_cast<std::size_t>(problem_.size()), std::nullopt);
  places_.clear();
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    if (graph_.neighbours(node).empty()) continue;
    const double* own = blocks_.own_block(node);
    for (std::size_t i = 0; i < blocks_.per_node(); ++i) {
      if (own[i * blocks_.per_node() + i] == 0.0) continue;  // rotations of a node of solids
      const std::size_t place = blocks_.place(node, i);
      numbers_[place] = static_cast<std::uint32_t>(places_.size());
      places_.push_back(place);
    }
  }
}

/// Of a symmetric one the lower half of the mean of the stiffness and its transpose.
SparseFactor::Matrix FullTangent::assemble() const {
  std::vector<Eigen::Triplet<double>> entries;
  const auto number = [&](std::uint32_t node, std::size_t unknown) {
    return numbers_[blocks_.place(node, unknown)];
  };
  const auto add = [&](std::uint32_t row, std::uint32_t column, double value) {
    if (is_symmetric() && row < column) std::swap(row, column);
    if (is_symmetric() && row != column) value *= 0.5;  // the other half comes from across the diagonal
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  const std::size_t n_unknowns = blocks_.per_node();
  blocks_.visit([&](std::uint32_t row_node, std::uint32_t column_node, const double* block) {
    for (std::size_t k = 0; k < n_unknowns * n_unknowns; ++k) {
      const auto column = number(column_node, k / n_unknowns), row = number(row_node, k % n_unknowns);
      if (row && column && (block[k] != 0.0 || row == column)) add(*row, *column, block[k]);
    }
  });
  const auto n = static_cast<Eigen::Index>(places_.size());
  SparseFactor::Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void FullTangent::follow(const Eigen::VectorXd& /*increment*/, bool has_new_elements) {
  if (has_new_elements) number_unknowns();
  exists_ = factor_->factorise(assemble());
}

void FullTangent::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  const auto n = static_cast<Eigen::Index>(places_.size());
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i)
    right(i) = residual(static_cast<Eigen::Index>(places_[static_cast<std::size_t>(i)]));
  const Eigen::VectorXd solution = exists_ ? factor_->solve(right) : right;
  z.setZero(residual.size());
  for (Eigen::Index i = 0; i < n; ++i)
    z(static_cast<Eigen::Index>(places_[static_cast<std::size_t>(i)])) = solution(i);
  problem_.project(z);
}

}  // namespace contactsim
