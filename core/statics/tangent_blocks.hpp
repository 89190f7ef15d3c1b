// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/body_blocks.hpp"
#include "core/statics/node_block.hpp"
#include "core/statics/tangent_probe.hpp"

namespace contactsim {

/// The whole stiffness by blocks of nodes: of the mesh by differences of residuals, and of what else joins
/// nodes, whether or not they share an element. Fixed and prescribed directions have a stiffness of their own
/// and join nothing.
class TangentBlocks {
 public:
  /// All must outlive it.
  ///   diagonal_scale  share of a node's stiffness that it has to the ground, too [1]
  TangentBlocks(StaticProblem& problem, const NodeGraph& graph, double diagonal_scale = 0.0);

  std::size_t per_node() const { return per_node_; }
  /// Where an unknown of a node stands in vectors.
  std::size_t place(std::uint32_t node, std::size_t unknown) const {
    return static_cast<std::size_t>(probe_.place(node, static_cast<Eigen::Index>(unknown)));
  }

  /// How much update() has made anew.
  struct Update {
    std::int64_t n_evaluations = 0;  ///< of the residual
    bool exists = false;             ///< else the residual cannot be evaluated there: not to be used
    bool has_new_elements = false;   ///< the mesh's own part, too
    double spring_size = 0.0;        ///< of all springs: what has changed far has another one
  };
  /// Finds the stiffness at an increment of the step: that of the mesh by differences, and the springs of
  /// contact in place of those before. Nodes that move with nothing held get shares of their stiffness to the
  /// ground.
  ///   shares     [n_nodes], or empty [1]
  ///   may_keep   the mesh's own part stays where it is there with the same shares
  Update update(const Eigen::VectorXd& increment, const std::vector<double>& shares, bool may_keep);
  /// Finds the mesh's own part. Returns the evaluations of the residual, 0 where there is none.
  std::int64_t renew(const Eigen::VectorXd& increment);
  /// Takes the parts of what else joins nodes, in place of those before. Nodes without elements are left out.
  void join(std::vector<NodeBlock> blocks);
  /// The largest stiffness of a node against moving, of the mesh [force/length].
  double largest() const { return largest_; }
  /// The stiffness that nodes have to the ground in the last update() that found the mesh's own part [size of
  /// the problem]; empty without any.
  const Eigen::VectorXd& ground() const { return ground_; }
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

  /// The mean of the stiffness and its transpose. Precondition: nodes do not turn.
  ///   keeps  the blocks for update(), which takes their memory twice; else they are given away
  BlockMatrix<3, 3> take_symmetric(bool keeps);

 private:
  /// Of bodies those of the largest of any node.
  void steady(const std::vector<double>& shares);
  double* block_of(std::uint32_t node, std::uint32_t neighbour) {
    return columns_.data() + offset(node, neighbour);
  }
  const double* block_of(std::uint32_t node, std::uint32_t neighbour) const {
    return columns_.data() + offset(node, neighbour);
  }
  std::size_t offset(std::uint32_t node, std::uint32_t neighbour) const;
  bool are_neighbours(std::uint32_t a, std::uint32_t b) const;
  std::vector<NodeBlock> take_apart();
  double find_largest() const;
  void hold_directions();
  void gather_bodies();
  void take_body(std::uint32_t body, const BodyBlocks::Block& stiffness);
  void steady_rotations();
  void make_symmetric();

  StaticProblem& problem_;
  const NodeGraph& graph_;
  TangentProbe probe_;
  std::size_t per_node_;
  std::vector<std::size_t> first_;  // [n_nodes + 1] of a node's blocks, over its neighbours
  // Of a node's unknowns, the rows of a neighbour [n_pairs x per_node x per_node].
  std::vector<double> columns_;
  std::vector<NodeBlock> joined_;     // of what else joins nodes
  std::vector<NodeBlock> of_bodies_;  // between rigid bodies and the mesh
  double diagonal_scale_;
  std::vector<double> shares_;  // of the last update() that found the mesh's own part
  Eigen::VectorXd ground_;      // [size of the problem], or empty [force/length]
  double largest_ = 0.0;
};

}  // namespace contactsim
