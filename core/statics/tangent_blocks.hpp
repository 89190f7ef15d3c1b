// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/body_blocks.hpp"
#include "core/statics/multigrid/block_matrix.hpp"
#include "core/statics/tangent_probe.hpp"

namespace contactsim {

/// A part of the stiffness: by what the forces of one node resist the displacements of another.
struct NodeBlock {
  std::uint32_t row, column;                     ///< nodes
  Eigen::Matrix3d stiffness;                     ///< [force/length]
  bool row_turns = false, column_turns = false;  ///< moments, and rotations, in their place
};

/// The stiffness of springs by nodes.
std::vector<NodeBlock> blocks_of(const std::vector<ContactSpring>& springs);

/// The whole stiffness by blocks of nodes: of the mesh by differences of residuals, and of what else joins
/// nodes, whether or not they share an element. Fixed and prescribed directions have a stiffness of their own
/// and join nothing.
class TangentBlocks {
 public:
  /// All must outlive it.
  TangentBlocks(StaticProblem& problem, const NodeGraph& graph);

  std::size_t per_node() const { return per_node_; }
  /// Where an unknown of a node stands in vectors.
  std::size_t place(std::uint32_t node, std::size_t unknown) const {
    return static_cast<std::size_t>(probe_.place(node, static_cast<Eigen::Index>(unknown)));
  }

  /// Finds the stiffness of the mesh at an increment of the step. Returns the evaluations of the residual, 0
  /// where there is none: the blocks are then not to be used.
  std::int64_t renew(const Eigen::VectorXd& increment);
  /// Takes the parts of what else joins nodes, in place of those before. Nodes without elements are left out.
  void join(std::vector<NodeBlock> blocks);
  /// Adds shares of their stiffness to the diagonal of nodes, of bodies those of the largest of any node
  /// [n_nodes].
  void steady(const std::vector<double>& shares);
  /// Whether the mesh's own part is there.
  bool exist() const { return !columns_.empty(); }
  /// The largest stiffness of a node against moving, of the mesh [force/length].
  double largest() const;
  /// Gives up the memory of the blocks.
  void clear();

  /// The block of a node on the diagonal [per_node x per_node]. Precondition: the node has elements.
  const double* own_block(std::uint32_t node) const { return block_of(node, node); }
  /// Calls take(row, column, block) for every pair of nodes, once or more: the sum is the negative
  /// derivatives of the forces of the node `row` by the unknowns of the node `column`, by columns.
  template <class Take>
  void visit(const Take& take) const {
    for (std::uint32_t node = 0; node < graph_.n_nodes(); ++node) {
      const double* block = columns_.data() + first_[node] * per_node_ * per_node_;
      for (const std::uint32_t neighbour : graph_.neighbours(node)) {
        take(neighbour, node, block);
        block += per_node_ * per_node_;
      }
    }
    const auto n = static_cast<Eigen::Index>(per_node_);
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n, n);
    for (const NodeBlock& part : joined_) {
      const Eigen::Index i = part.row_turns ? 3 : 0, j = part.column_turns ? 3 : 0;
      whole.block<3, 3>(i, j) = part.stiffness;
      take(part.row, part.column, static_cast<const double*>(whole.data()));
      whole.block<3, 3>(i, j).setZero();
    }
  }

  /// Turns the blocks into the mean of the stiffness and its transpose, and gives them away. Precondition:
  /// nodes do not turn.
  ///   diagonal_scale  share of the diagonal that is added to it [1]
  BlockMatrix<3, 3> take_symmetric(double diagonal_scale);

 private:
  double* block_of(std::uint32_t node, std::uint32_t neighbour) {
    return columns_.data() + offset(node, neighbour);
  }
  const double* block_of(std::uint32_t node, std::uint32_t neighbour) const {
    return columns_.data() + offset(node, neighbour);
  }
  std::size_t offset(std::uint32_t node, std::uint32_t neighbour) const;
  bool are_neighbours(std::uint32_t a, std::uint32_t b) const;
  std::vector<NodeBlock> take_apart();
  void hold_directions();
  void gather_bodies();
  void take_body(std::uint32_t body, const BodyBlocks::Block& stiffness);
  void steady_rotations();
  void make_symmetric(double diagonal_scale);

  StaticProblem& problem_;
  const NodeGraph& graph_;
  TangentProbe probe_;
  std::size_t per_node_;
  std::vector<std::size_t> first_;  // [n_nodes + 1] of a node's blocks, over its neighbours
  // Of a node's unknowns, the rows of a neighbour [n_pairs x per_node x per_node].
  std::vector<double> columns_;
  std::vector<NodeBlock> joined_;     // of what else joins nodes
  std::vector<NodeBlock> of_bodies_;  // between rigid bodies and the mesh
};

}  // namespace contactsim
