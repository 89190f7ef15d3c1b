// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/nodal_blocks.hpp"

#include <algorithm>

#include "core/base/threads.hpp"
#include "core/statics/positive_inverse.hpp"

namespace contactsim {

namespace {

/// Adds what springs resist each node's own motion with.
///   blocks  [per_node x per_node n_nodes]
void add_contact(const std::vector<ContactSpring>& springs, Eigen::MatrixXd& blocks) {
  const Eigen::Index per_node = blocks.rows();
  for (const ContactSpring& spring : springs) {
    spring.visit_blocks([&](const SpringEnd& a, const SpringEnd& b, const Eigen::Matrix3d& block) {
      if (a.node == b.node)
        blocks.block<3, 3>(a.turns ? 3 : 0, per_node * b.node + (b.turns ? 3 : 0)) += block;
    });
  }
}

/// Sums the stiffness of the nodes of bodies, each against its own motion, which is more than the whole has.
///   blocks  [per_node x per_node n_nodes]
void carry(const StaticBodies& bodies, Eigen::MatrixXd& blocks) {
  const Eigen::Index per_node = blocks.rows();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    for (const NodeIndex node : bodies.body(i).nodes) {
      auto block = blocks.middleCols(per_node * Eigen::Index{node.value}, per_node);
      for (Eigen::Index first = 0; first < per_node; first += 3) {
        const Eigen::Matrix3d own = block.block<3, 3>(first, first);
        for (const Carrier& carrier : bodies.carriers(node.value, first > 0))
          blocks.block<3, 3>(0, per_node * Eigen::Index{carrier.node}) +=
              carrier.share.transpose() * own * carrier.share;
      }
      block.setZero();
    }
    blocks.block<3, 3>(0, per_node * Eigen::Index{bodies.turning_node(i)}) += bodies.turning_stiffness(i);
  }
}

/// Gives bodies a stiffness to the ground where they are free, and takes off that of held directions.
void steady(const StaticProblem& problem, double largest, Eigen::MatrixXd& blocks) {
  const StaticBodies& bodies = problem.bodies();
  const Eigen::Index per_node = blocks.rows();
  const double ground = StaticBodies::ground_share * (largest > 0.0 ? largest : 1.0);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    for (const std::uint32_t node : {bodies.centre_node(i), bodies.turning_node(i)})
      blocks.block<3, 3>(0, per_node * Eigen::Index{node}).diagonal().array() += ground;
  }
  problem.visit_held([&](std::uint32_t node, Eigen::Index, const Eigen::Matrix3d& held) {
    if (bodies.is_of_mesh(node)) return;
    auto block = blocks.block<3, 3>(0, per_node * Eigen::Index{node});
    const Eigen::Matrix3d free = Eigen::Matrix3d::Identity() - held;
    block = (free * block * free).eval();
  });
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
  carry(problem_.bodies(), blocks);
  steady(problem_, largest_, blocks);
  add_contact(problem_.contact_springs(), blocks);
  const auto n_nodes = static_cast<std::size_t>(probe_.n_nodes());
  parallel_for(n_nodes, threads_for(100 * n_nodes), [&](std::size_t node) {
    const auto first = static_cast<Eigen::Index>(node) * per_node_;
    const Eigen::VectorXd scales = problem_.unknown_scales(static_cast<std::uint32_t>(node));
    const Eigen::MatrixXd scaled =
        scales.asDiagonal() * blocks.middleCols(first, per_node_) * scales.asDiagonal();
    inverses_.middleCols(first, per_node_) =
        scales.asDiagonal() * positive_inverse<Eigen::Dynamic>(scaled) * scales.asDiagonal();
  });
  return n_evaluations;
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
}

}  // namespace contactsim
