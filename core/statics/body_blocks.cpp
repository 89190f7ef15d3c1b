// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/body_blocks.hpp"

namespace contactsim {

BodyBlocks::BodyBlocks(const StaticProblem& problem)
    : problem_(problem), blocks_(problem.bodies().size(), Block::Zero()) {
  for (std::uint32_t i = 0; i < blocks_.size(); ++i)
    blocks_[i].bottomRightCorner<3, 3>() = problem.bodies().turning_stiffness(i);
}

bool BodyBlocks::add(std::uint32_t row, std::uint32_t column, const Eigen::Matrix3d& stiffness) {
  const StaticBodies& bodies = problem_.bodies();
  if (bodies.is_of_mesh(row) || bodies.is_of_mesh(column)) return false;
  const std::uint32_t body = bodies.owner(row), centre = bodies.centre_node(body);
  if (body != bodies.owner(column)) return false;
  blocks_[body].block<3, 3>(row == centre ? 0 : 3, column == centre ? 0 : 3) += stiffness;
  return true;
}

void BodyBlocks::project() {
  const StaticBodies& bodies = problem_.bodies();
  std::vector<Block> free(blocks_.size(), Block::Identity());
  problem_.held().visit([&](std::uint32_t node, Eigen::Index, const Eigen::Matrix3d& held) {
    if (bodies.is_of_mesh(node)) return;
    const std::uint32_t body = bodies.owner(node);
    const Eigen::Index first = node == bodies.centre_node(body) ? 0 : 3;
    free[body].block<3, 3>(first, first) -= held;
  });
  for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_[i] = (free[i] * blocks_[i] * free[i]).eval();
}

}  // namespace contactsim
