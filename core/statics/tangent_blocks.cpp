// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/tangent_blocks.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace contactsim {

namespace {

/// The size of springs: another one where some have come, gone, begun to stick or to slide.
double size_of(const std::vector<ContactSpring>& springs) {
  double size = 0.0;
  for (const ContactSpring& spring : springs) size += spring.coupling.norm() * spring.stiffness.norm();
  return size;
}

}  // namespace

TangentBlocks::TangentBlocks(StaticProblem& problem, const NodeGraph& graph, double diagonal_scale)
    : problem_(problem),
      graph_(graph),
      probe_(problem, graph, ColourDistance::two_elements),
      per_node_(static_cast<std::size_t>(probe_.unknowns_per_node())),
      diagonal_scale_(diagonal_scale) {
  std::size_t n_pairs = 0;
  for (std::uint32_t node = 0; node < graph.n_nodes(); ++node) {
    first_.push_back(n_pairs);
    n_pairs += graph.neighbours(node).size();
  }
  first_.push_back(n_pairs);
}

std::size_t TangentBlocks::offset(std::uint32_t node, std::uint32_t neighbour) const {
  const auto neighbours = graph_.neighbours(node);
  const auto place = std::lower_bound(neighbours.begin(), neighbours.end(), neighbour) - neighbours.begin();
  return (first_[node] + static_cast<std::size_t>(place)) * per_node_ * per_node_;
}

bool TangentBlocks::are_neighbours(std::uint32_t a, std::uint32_t b) const {
  const auto neighbours = graph_.neighbours(a);
  return std::binary_search(neighbours.begin(), neighbours.end(), b);
}

/// Gives directions that are held, which have no stiffness left, that of their node.
void TangentBlocks::hold_directions() {
  problem_.held().visit([&](std::uint32_t node, Eigen::Index first, const Eigen::Matrix3d& held) {
    if (graph_.neighbours(node).empty()) return;
    Eigen::Map<Eigen::MatrixXd> block(block_of(node, node), static_cast<Eigen::Index>(per_node_),
                                      static_cast<Eigen::Index>(per_node_));
    const double own = block.diagonal().segment<3>(first).maxCoeff();
    block.block<3, 3>(first, first) += (own > 0.0 ? own : 1.0) * held;
  });
}

/// Turning about the normal of a flat shell meets next to no stiffness: along such directions a node
/// gets a share of the stiffness that it has along others.
void TangentBlocks::steady_rotations() {
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

TangentBlocks::Update TangentBlocks::update(const Eigen::VectorXd& increment,
                                            const std::vector<double>& shares, bool may_keep) {
  Eigen::VectorXd residual;
  Update update{.n_evaluations = 1};
  if (!problem_.evaluate(increment, residual)) return update;
  problem_.find_springs();
  update.spring_size = size_of(problem_.springs());
  if (!may_keep || columns_.empty() || shares != shares_) {
    const std::int64_t n_probes = renew(increment);
    update.n_evaluations += n_probes;
    if (n_probes == 0) return update;
    update.has_new_elements = true;
    largest_ = find_largest();
    shares_ = shares;
    steady(shares);
  }
  join(blocks_of(problem_.springs()));
  update.exists = true;
  return update;
}

/// Gives what nodes of rigid bodies resist to what moves them.
void TangentBlocks::gather_bodies() {
  const StaticBodies& rigid = problem_.bodies();
  BodyBlocks own(problem_);
  of_bodies_.clear();
  const auto carry = [&](const Carrier& row, const Carrier& column, const Eigen::Matrix3d& stiffness) {
    const Eigen::Matrix3d carried = row.share.transpose() * stiffness * column.share;
    if (!own.add(row.node, column.node, carried))
      of_bodies_.push_back({row.node, column.node, carried, row.turns, column.turns});
  };
  const auto n = static_cast<Eigen::Index>(per_node_);
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    for (const std::uint32_t neighbour : graph_.neighbours(node)) {
      if (!rigid.moves(node) && !rigid.moves(neighbour)) continue;
      Eigen::Map<Eigen::MatrixXd> block(block_of(node, neighbour), n, n);
      for (Eigen::Index part = 0; part < n * n / 9; ++part) {
        const Eigen::Index i = 3 * (part % (n / 3)), j = 3 * (part / (n / 3));
        const Eigen::Matrix3d stiffness = block.block<3, 3>(i, j);
        if (stiffness.isZero(0.0)) continue;
        for (const Carrier& row : rigid.carriers(neighbour, i > 0)) {
          for (const Carrier& column : rigid.carriers(node, j > 0)) carry(row, column, stiffness);
        }
      }
      block.setZero();
    }
  }
  own.project();
  for (std::uint32_t i = 0; i < rigid.size(); ++i) take_body(i, own.of(i));
}

/// Takes what a body resists its own motion with.
void TangentBlocks::take_body(std::uint32_t body, const BodyBlocks::Block& stiffness) {
  const std::uint32_t first = problem_.bodies().centre_node(body);
  const auto n = static_cast<Eigen::Index>(per_node_);
  for (std::uint32_t row = 0; row < 2; ++row) {
    for (std::uint32_t column = 0; column < 2; ++column)
      Eigen::Map<Eigen::MatrixXd>(block_of(first + column, first + row), n, n).topLeftCorner<3, 3>() =
          stiffness.block<3, 3>(3 * Eigen::Index{row}, 3 * Eigen::Index{column});
  }
}

std::int64_t TangentBlocks::renew(const Eigen::VectorXd& increment) {
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
  if (!problem_.bodies().empty()) gather_bodies();
  hold_directions();
  steady_rotations();
  return n_evaluations;
}

void TangentBlocks::join(std::vector<NodeBlock> blocks) {
  blocks.insert(blocks.end(), of_bodies_.begin(), of_bodies_.end());
  const FreeProjections free(problem_.held(), graph_.n_nodes());
  joined_.clear();
  for (NodeBlock block : blocks) {
    if (graph_.neighbours(block.row).empty() || graph_.neighbours(block.column).empty()) continue;
    const Eigen::Matrix3d* row = free.find(block.row, block.row_turns);
    const Eigen::Matrix3d* column = free.find(block.column, block.column_turns);
    if (row != nullptr) block.stiffness = (*row * block.stiffness).eval();
    if (column != nullptr) block.stiffness = (block.stiffness * *column).eval();
    joined_.push_back(block);
  }
}

void TangentBlocks::steady(const std::vector<double>& shares) {
  const auto n = static_cast<Eigen::Index>(per_node_);
  const double largest_of_any = largest_ > 0.0 ? largest_ : 1.0;
  ground_.resize(0);
  const bool has_shares = std::ranges::any_of(shares, [](double share) { return share > 0.0; });
  if (!has_shares && !(diagonal_scale_ > 0.0)) return;
  ground_.setZero(problem_.size());
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    if (graph_.neighbours(node).empty()) continue;
    Eigen::Map<Eigen::MatrixXd> own(block_of(node, node), n, n);
    const double share = shares.empty() ? 0.0 : shares[node];
    Eigen::VectorXd added = diagonal_scale_ * own.diagonal();
    if (problem_.bodies().is_of_mesh(node))
      added += share * own.diagonal();
    else
      added.head<3>().array() += share * largest_of_any;
    own.diagonal() += added;
    for (Eigen::Index i = 0; i < n; ++i)
      ground_(static_cast<Eigen::Index>(place(node, static_cast<std::size_t>(i)))) = added(i);
  }
}

double TangentBlocks::find_largest() const {
  double largest = 0.0;
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    if (graph_.neighbours(node).empty() || !problem_.bodies().is_of_mesh(node)) continue;
    const double* own = own_block(node);
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, own[i * per_node_ + i]);
  }
  return largest;
}

/// Each pair of blocks across the diagonal is worked out at its earlier node.
void TangentBlocks::make_symmetric() {
  parallel_for(graph_.n_nodes(), threads_for(first_.back()), [&](std::uint32_t node) {
    for (const std::uint32_t other : graph_.neighbours(node)) {
      if (other < node) continue;
      Eigen::Map<Eigen::Matrix3d> here(block_of(node, other)), across(block_of(other, node));
      // Here stand the forces of the other node by the displacements of this one.
      const Eigen::Matrix3d mean = 0.5 * (here.transpose() + across);
      here = mean;
      across = mean.transpose();
    }
  });
}

/// Adds the parts between neighbours to theirs; returns the others.
std::vector<NodeBlock> TangentBlocks::take_apart() {
  std::vector<NodeBlock> apart;
  for (const NodeBlock& part : joined_) {
    if (are_neighbours(part.column, part.row)) {
      Eigen::Map<Eigen::Matrix3d> block(block_of(part.column, part.row));
      block += part.stiffness;
    } else {
      apart.push_back(part);
    }
  }
  return apart;
}

BlockMatrix<3, 3> TangentBlocks::take_symmetric(bool keeps) {
  std::vector<double> kept;
  if (keeps) kept = columns_;
  const std::vector<NodeBlock> apart = take_apart();
  make_symmetric();
  BlockMatrix<3, 3> matrix;
  matrix.n_columns = graph_.n_nodes();
  matrix.first = first_;
  matrix.columns.reserve(first_.back());
  for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
    const auto neighbours = graph_.neighbours(node);
    matrix.columns.insert(matrix.columns.end(), neighbours.begin(), neighbours.end());
  }
  matrix.values = std::move(columns_);
  if (!problem_.bodies().empty()) matrix = without_moved(matrix, problem_.bodies());
  if (!apart.empty()) matrix = with_blocks(matrix, symmetric_halves(apart));
  columns_ = std::move(kept);
  joined_ = {};
  return matrix;
}

}  // namespace contactsim
