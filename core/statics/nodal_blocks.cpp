// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/nodal_blocks.hpp"

#include <algorithm>

#include "core/base/threads.hpp"
#include "core/statics/positive_inverse.hpp"

namespace contactsim {

namespace {

/// Adds what springs resist the motion of each node, and of each rigid body, with.
///   blocks  [per_node x per_node n_nodes]
void add_contact(const std::vector<ContactSpring>& springs, Eigen::MatrixXd& blocks, BodyBlocks& bodies) {
  const Eigen::Index per_node = blocks.rows();
  for (const ContactSpring& spring : springs) {
    spring.visit_blocks([&](const SpringEnd& a, const SpringEnd& b, const Eigen::Matrix3d& block) {
      if (!bodies.add(a.node, b.node, block) && a.node == b.node)
        blocks.block<3, 3>(a.turns ? 3 : 0, per_node * b.node + (b.turns ? 3 : 0)) += block;
    });
  }
}

/// Takes the stiffness of nodes of rigid bodies, each against its own motion, to their bodies: more than the
/// whole has.
///   blocks  [per_node x per_node n_nodes]
void carry(const StaticBodies& rigid, Eigen::MatrixXd& blocks, BodyBlocks& bodies) {
  const Eigen::Index per_node = blocks.rows();
  for (std::uint32_t i = 0; i < rigid.size(); ++i) {
    for (const NodeIndex node : rigid.body(i).nodes) {
      auto block = blocks.middleCols(per_node * Eigen::Index{node.value}, per_node);
      for (Eigen::Index first = 0; first < per_node; first += 3) {
        const Eigen::Matrix3d own = block.block<3, 3>(first, first);
        const std::vector<Carrier> carriers = rigid.carriers(node.value, first > 0);
        for (const Carrier& row : carriers) {
          for (const Carrier& column : carriers)
            bodies.add(row.node, column.node, row.share.transpose() * own * column.share);
        }
      }
      block.setZero();
    }
  }
}

}  // namespace

NodalBlocks::NodalBlocks(StaticProblem& problem, const NodeGraph& graph)
    : problem_(problem),
      probe_(problem, graph, ColourDistance::one_element),
      per_node_(probe_.unknowns_per_node()),
      inverses_(Eigen::MatrixXd::Zero(per_node_, per_node_ * probe_.n_nodes())) {}

std::int64_t NodalBlocks::renew(const Eigen::VectorXd& increment) {
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(per_node_, per_node_ * probe_.n_nodes());
  const std::int64_t n_evaluations = probe_.differentiate(
      increment, [&](std::uint32_t node, Eigen::Index unknown, const Eigen::VectorXd& column) {
        auto block = blocks.col(node * per_node_ + unknown);
        for (Eigen::Index i = 0; i < per_node_; ++i) block(i) = column(probe_.place(node, i));
      });
  if (n_evaluations == 0) return 0;
  largest_ = 0.0;
  for (Eigen::Index i = 0; i < probe_.n_nodes(); ++i)
    largest_ = std::max(largest_, blocks.block<3, 3>(0, per_node_ * i).diagonal().maxCoeff());
  BodyBlocks bodies(problem_);
  carry(problem_.bodies(), blocks, bodies);
  problem_.find_springs();
  add_contact(problem_.springs(), blocks, bodies);
  const auto n_nodes = static_cast<std::size_t>(probe_.n_nodes());
  parallel_for(n_nodes, threads_for(100 * n_nodes), [&](std::size_t node) {
    const auto first = static_cast<Eigen::Index>(node) * per_node_;
    const Eigen::VectorXd scales = problem_.unknowns().scales_of(static_cast<std::uint32_t>(node));
    const Eigen::MatrixXd scaled =
        scales.asDiagonal() * blocks.middleCols(first, per_node_) * scales.asDiagonal();
    inverses_.middleCols(first, per_node_) =
        scales.asDiagonal() * positive_inverse<Eigen::Dynamic>(scaled) * scales.asDiagonal();
  });
  invert(bodies);
  return n_evaluations;
}

/// Bodies that nothing resists get a stiffness to the ground.
void NodalBlocks::invert(BodyBlocks& bodies) {
  const double ground = StaticBodies::ground_share * (largest_ > 0.0 ? largest_ : 1.0);
  body_inverses_.clear();
  for (std::uint32_t i = 0; i < problem_.bodies().size(); ++i) bodies.of(i).diagonal().array() += ground;
  bodies.project();
  for (std::uint32_t i = 0; i < problem_.bodies().size(); ++i)
    body_inverses_.push_back(positive_inverse<6>(bodies.of(i)));
}

void NodalBlocks::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const {
  z.resize(residual.size());
  const auto n_nodes = static_cast<std::size_t>(probe_.n_nodes());
  parallel_for(n_nodes, threads_for(n_nodes), [&](std::size_t i) {
    const auto node = static_cast<std::uint32_t>(i);
    const auto first = static_cast<Eigen::Index>(i) * per_node_;
    for (Eigen::Index row = 0; row < per_node_; ++row) {
      double sum = 0.0;
      for (Eigen::Index column = 0; column < per_node_; ++column)
        sum += inverses_(row, first + column) * residual(probe_.place(node, column));
      z(probe_.place(node, row)) = sum;
    }
  });
  for (std::uint32_t i = 0; i < body_inverses_.size(); ++i) {
    const Eigen::Index first = 3 * Eigen::Index{problem_.bodies().centre_node(i)};
    z.segment<6>(first) = body_inverses_[i] * residual.segment<6>(first);
  }
}

}  // namespace contactsim
