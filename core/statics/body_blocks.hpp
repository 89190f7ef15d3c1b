// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/static_problem.hpp"

namespace contactsim {

/// What each rigid body resists its own motion with, by the unknowns of its two nodes.
class BodyBlocks {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;

  /// The problem must outlive it. The blocks begin with what the forces of now do as bodies turn.
  explicit BodyBlocks(const StaticProblem& problem);

  /// Adds the stiffness between two nodes when both are of one body. Returns whether they are.
  bool add(std::uint32_t row, std::uint32_t column, const Eigen::Matrix3d& stiffness);
  /// Takes off what moves along held directions.
  void project();
  Block& of(std::uint32_t body) { return blocks_[body]; }

 private:
  const StaticProblem& problem_;
  std::vector<Block> blocks_;  // [n_bodies] [force/length]
};

}  // namespace contactsim
