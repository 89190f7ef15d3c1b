// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/full_tangent.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace contactsim {

namespace {

/// The size of the springs: another one where some have come, gone, begun to stick or to slide.
double size_of(const std::vector<ContactSpring>& springs) {
  double size = 0.0;
  for (const ContactSpring& spring : springs) size += spring.coupling.norm() * spring.stiffness.norm();
  return size;
}

}  // namespace

FullTangent::FullTangent(StaticProblem& problem, const NodeGraph& graph, const FullTangentSettings& settings)
    : problem_(problem),
      graph_(graph),
      settings_(settings),
      probe_(problem, graph, ColourDistance::two_elements),
      per_node_(static_cast<std::size_t>(probe_.unknowns_per_node())),
      factor_(make_sparse_factor(is_symmetric())) {
  std::size_t n_pairs = 0;
  for (std::uint32_t node = 0; node < graph.n_nodes(); ++node) {
    first_.push_back(n_pairs);
    n_pairs += graph.neighbours(node).size();
  }
  first_.push_back(n_pairs);
}

double* FullTangent::block_of(std::uint32_t node, std::uint32_t neighbour) {
  const auto neighbours = graph_.neighbours(node);
  const auto place = std::lower_bound(neighbours.begin(), neighbours.end(), neighbour) - neighbours.begin();
  return columns_.data() + (first_[node] + static_cast<std::size_t>(place)) * per_node_ * per_node_;
}

/// Gives directions that are held, which have no stiffness left, that of their node.
void FullTangent::hold_directions() {
  problem_.visit_held([&](std::uint32_t node, Eigen::Index first, const Eigen::Matrix3d& held) {
    if (graph_.neighbours(node).empty()) return;
    Eigen::Map<Eigen::MatrixXd> block(block_of(node, node), static_cast<Eigen::Index>(per_node_),
                                      static_cast<Eigen::Index>(per_node_));
    const double own = block.diagonal().segment<3>(first).maxCoeff();
    block.block<3, 3>(first, first) += (own > 0.0 ? own : 1.0) * held;
  });
}

/// Turning about the normal of a flat shell meets next to no stiffness: along such directions a node
/// gets a share of the stiffness that it has along others.
void FullTangent::steady_rotations() {
  constexpr double nothing = 1e-5, share = 1e-3;
  const auto n = static_cast<Eigen::Index>(per_node_);
  for (std::uint32_t node = 0; node < graph_.n_nodes() && per_node_ > 3; ++node) {
    if (graph_.neighbours(node).empty()) continue;
    Eigen::Map<Eigen::MatrixXd> block(block_of(node, node), n, n);
    const Eigen::Matrix3d turning = block.bottomRightCorner<3, 3>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(0.5 * (turning + turning.transpose()));
    const double largest = solver.eigenvalues()(2);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Vector3d axis = solver.eigenvectors().col(i);
      if (std::abs(solver.eigenvalues()(i)) <= nothing * largest)
        block.bottomRightCorner<3, 3>() += share * largest * axis * axis.transpose();
    }
  }
}

void FullTangent::steady_free_bodies() {
  const auto n = static_cast<Eigen::Index>(per_node_);
  for (std::uint32_t node = 0; node < free_shares_.size(); ++node) {
    if (free_shares_[node] == 0.0) continue;
    Eigen::Map<Eigen::MatrixXd> block(block_of(node, node), n, n);
    block.diagonal() *= 1.0 + free_shares_[node];
  }
}

void FullTangent::number_unknowns() {
  numbers_.assign(static_cast<std::size_t>(problem_.size()), -1);
  places_.clear();
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    if (graph_.neighbours(node).empty()) continue;
    const double* own = block_of(node, node);
    for (std::size_t i = 0; i < per_node_; ++i) {
      if (own[i * per_node_ + i] == 0.0) continue;  // rotations of a node of solids
      const auto place = static_cast<std::size_t>(probe_.place(node, static_cast<Eigen::Index>(i)));
      numbers_[place] = static_cast<int>(places_.size());
      places_.push_back(place);
    }
  }
}

/// Of a symmetric one the lower half of the mean of the stiffness and its transpose.
SparseFactor::Matrix FullTangent::assemble() {
  std::vector<Eigen::Triplet<double>> entries;
  const auto number = [&](std::uint32_t node, std::size_t unknown) {
    return numbers_[static_cast<std::size_t>(probe_.place(node, static_cast<Eigen::Index>(unknown)))];
  };
  const auto add = [&](int row, int column, double value) {
    if (is_symmetric() && row < column) std::swap(row, column);
    if (is_symmetric() && row != column) value *= 0.5;  // the other half comes from across the diagonal
    if (row == column) value *= 1.0 + settings_.tangent_diagonal_scale;
    entries.emplace_back(row, column, value);
  };
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    for (const std::uint32_t other : graph_.neighbours(node)) {
      const double* rows = block_of(node, other);
      for (std::size_t k = 0; k < per_node_ * per_node_; ++k) {
        const int column = number(node, k / per_node_), row = number(other, k % per_node_);
        if (row >= 0 && column >= 0 && (rows[k] != 0.0 || row == column)) add(row, column, rows[k]);
      }
    }
  }
  for (const ContactSpring& spring : springs_) {
    spring.visit_blocks([&](const SpringEnd& a, const SpringEnd& b, const Eigen::Matrix3d& block) {
      for (Eigen::Index k = 0; k < block.size(); ++k) {
        const Eigen::Index i = k % 3, j = k / 3;
        const int row = number(a.node, static_cast<std::size_t>(i + (a.turns ? 3 : 0))),
                  column = number(b.node, static_cast<std::size_t>(j + (b.turns ? 3 : 0)));
        if (row >= 0 && column >= 0 && block(i, j) != 0.0) add(row, column, block(i, j));
      }
    });
  }
  const auto n = static_cast<Eigen::Index>(places_.size());
  SparseFactor::Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::int64_t FullTangent::probe_elements(const Eigen::VectorXd& increment) {
  columns_.assign(first_.back() * per_node_ * per_node_, 0.0);
  const std::int64_t n_evaluations = probe_.differentiate(
      increment, [&](std::uint32_t node, Eigen::Index unknown, const Eigen::VectorXd& column) {
        double* rows = columns_.data() + first_[node] * per_node_ * per_node_ +
                       static_cast<std::size_t>(unknown) * per_node_;
        for (const std::uint32_t neighbour : graph_.neighbours(node)) {
          for (std::size_t i = 0; i < per_node_; ++i)
            rows[i] = column(probe_.place(neighbour, static_cast<Eigen::Index>(i)));
          rows += per_node_ * per_node_;
        }
      });
  if (n_evaluations == 0) return 0;
  hold_directions();
  steady_rotations();
  steady_free_bodies();
  number_unknowns();
  find_largest();
  return n_evaluations;
}

std::int64_t FullTangent::renew(const Eigen::VectorXd& increment, bool may_keep_elements) {
  constexpr double same = 1e-3;
  Eigen::VectorXd residual;
  if (!problem_.evaluate(increment, residual)) return 1;
  std::int64_t n_evaluations = 1;
  springs_ = problem_.contact_springs();
  const double size = size_of(springs_);
  const bool keeps = may_keep_elements && !columns_.empty() &&
                     std::abs(size - spring_size_) > same * std::max(size, spring_size_);
  if (!keeps) {
    const std::int64_t n_probes = probe_elements(increment);
    if (n_probes == 0) return n_evaluations;
    n_evaluations += n_probes;
  }
  spring_size_ = size;
  exists_ = factor_->factorise(assemble());
  return n_evaluations;
}

void FullTangent::find_largest() {
  largest_ = 0.0;
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    if (graph_.neighbours(node).empty()) continue;
    const double* own = block_of(node, node);
    for (std::size_t i = 0; i < 3; ++i) largest_ = std::max(largest_, own[i * per_node_ + i]);
  }
}

void FullTangent::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  const auto n = static_cast<Eigen::Index>(places_.size());
  Eigen::VectorXd of_matrix(n);
  for (Eigen::Index i = 0; i < n; ++i)
    of_matrix(i) = residual(static_cast<Eigen::Index>(places_[static_cast<std::size_t>(i)]));
  of_matrix = factor_->solve(of_matrix);
  z.setZero(residual.size());
  for (Eigen::Index i = 0; i < n; ++i)
    z(static_cast<Eigen::Index>(places_[static_cast<std::size_t>(i)])) = of_matrix(i);
  problem_.project(z);
}

}  // namespace contactsim
