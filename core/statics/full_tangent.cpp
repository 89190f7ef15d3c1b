// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/full_tangent.hpp"

#include <utility>

#include "core/statics/gmres.hpp"

namespace contactsim {

FullTangent::FullTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings)
    : problem_(problem),
      graph_(graph),
      settings_(settings),
      blocks_(problem, graph),
      factor_(make_sparse_factor(is_symmetric())) {}

void FullTangent::number_unknowns() {
  numbers_.assign(static_cast<std::size_t>(problem_.size()), -1);
  places_.clear();
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    if (graph_.neighbours(node).empty()) continue;
    const double* own = blocks_.own_block(node);
    for (std::size_t i = 0; i < blocks_.per_node(); ++i) {
      if (own[i * blocks_.per_node() + i] == 0.0) continue;  // rotations of a node of solids
      const std::size_t place = blocks_.place(node, i);
      numbers_[place] = static_cast<int>(places_.size());
      places_.push_back(place);
    }
  }
}

/// Of a symmetric one the lower half of the mean of the stiffness and its transpose.
SparseFactor::Matrix FullTangent::assemble() {
  std::vector<Eigen::Triplet<double>> entries;
  const auto number = [&](std::uint32_t node, std::size_t unknown) {
    return numbers_[blocks_.place(node, unknown)];
  };
  const auto add = [&](int row, int column, double value) {
    if (is_symmetric() && row < column) std::swap(row, column);
    if (is_symmetric() && row != column) value *= 0.5;  // the other half comes from across the diagonal
    if (row == column) value *= 1.0 + settings_.tangent_diagonal_scale;
    entries.emplace_back(row, column, value);
  };
  const std::size_t n_unknowns = blocks_.per_node();
  blocks_.visit([&](std::uint32_t row_node, std::uint32_t column_node, const double* block) {
    for (std::size_t k = 0; k < n_unknowns * n_unknowns; ++k) {
      const int column = number(column_node, k / n_unknowns), row = number(row_node, k % n_unknowns);
      if (row >= 0 && column >= 0 && (block[k] != 0.0 || row == column)) add(row, column, block[k]);
    }
  });
  const auto n = static_cast<Eigen::Index>(places_.size());
  SparseFactor::Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::int64_t FullTangent::renew(const Eigen::VectorXd& increment, bool may_keep_elements) {
  const TangentBlocks::Update update = blocks_.update(increment, free_shares_, may_keep_elements);
  if (!update.exists) return update.n_evaluations;
  if (update.has_new_elements) {
    const std::vector<std::size_t> before = places_;
    number_unknowns();
    if (places_ != before) exists_ = false;
  }
  matrix_ = assemble();
  is_current_ = false;
  // A step begins with a factor of its own, so that a restart has the same one.
  if (!exists_ || !is_symmetric() || !may_keep_elements) factorise();
  return update.n_evaluations;
}

bool FullTangent::factorise() const {
  exists_ = is_current_ = factor_->factorise(matrix_);
  return exists_;
}

Eigen::VectorXd FullTangent::to_unknowns(const Eigen::VectorXd& vector) const {
  Eigen::VectorXd unknowns(static_cast<Eigen::Index>(places_.size()));
  for (Eigen::Index i = 0; i < unknowns.size(); ++i)
    unknowns(i) = vector(static_cast<Eigen::Index>(places_[static_cast<std::size_t>(i)]));
  return unknowns;
}

Eigen::VectorXd FullTangent::from_unknowns(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(problem_.size());
  for (Eigen::Index i = 0; i < unknowns.size(); ++i)
    vector(static_cast<Eigen::Index>(places_[static_cast<std::size_t>(i)])) = unknowns(i);
  return vector;
}

void FullTangent::add_unsymmetric(const Eigen::VectorXd& direction, Eigen::VectorXd& product) const {
  Eigen::VectorXd felt = Eigen::VectorXd::Zero(problem_.size());
  blocks_.add_unsymmetric(from_unknowns(direction), felt);
  product += to_unknowns(felt);
}

/// Conjugate gradients, or minimal residuals, which make Newton's steps inexact.
bool FullTangent::iterate(const Eigen::VectorXd& right, Eigen::VectorXd& solution) const {
  constexpr double tolerance = 1e-4;
  constexpr int max_iterations = 30;
  const bool has_unsymmetric = blocks_.has_unsymmetric();
  const auto multiply = [&](const Eigen::VectorXd& direction, Eigen::VectorXd& product) {
    product = matrix_.selfadjointView<Eigen::Lower>() * direction;
    if (has_unsymmetric) add_unsymmetric(direction, product);
  };
  const auto precondition = [&](const Eigen::VectorXd& left, Eigen::VectorXd& step) {
    step = factor_->solve(left);
  };
  const LinearSearch search =
      has_unsymmetric ? gmres(multiply, precondition, right, tolerance, max_iterations, solution)
                      : conjugate_gradients(multiply, precondition, right, tolerance, max_iterations, solution);
  n_iterations_ += search.n_iterations;
  return search.end == LinearSearch::End::converged;
}

void FullTangent::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  const Eigen::VectorXd right = to_unknowns(residual);
  Eigen::VectorXd solution;
  if (is_current_ || !iterate(right, solution)) {
    if (!is_current_) factorise();
    if (!blocks_.has_unsymmetric())
      solution = factor_->solve(right);
    else
      iterate(right, solution);
  }
  z = from_unknowns(solution);
  problem_.project(z);
}

}  // namespace contactsim
