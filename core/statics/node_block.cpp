// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/node_block.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace contactsim {

std::vector<NodeBlock> blocks_of(const std::vector<ContactSpring>& springs) {
  std::vector<NodeBlock> blocks;
  for (const ContactSpring& spring : springs) {
    spring.visit_blocks([&](const SpringEnd& a, const SpringEnd& b, const Eigen::Matrix3d& block) {
      blocks.push_back({a.node, b.node, block, a.turns, b.turns});
    });
  }
  return blocks;
}

BlockMatrix<3, 3> with_blocks(const BlockMatrix<3, 3>& matrix, const std::vector<NodeBlock>& blocks) {
  BlockMatrix<3, 3> merged;
  merged.n_columns = matrix.n_columns;
  merged.first.push_back(0);
  merged.columns.reserve(matrix.n_blocks() + blocks.size());
  merged.values.reserve(9 * merged.columns.capacity());
  auto next = blocks.begin();
  const auto append = [&](std::uint32_t column, const double* block) {
    merged.columns.push_back(column);
    merged.values.insert(merged.values.end(), block, block + 9);
  };
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) {
    for (std::size_t k = matrix.first[row]; k < matrix.first[row + std::size_t{1}]; ++k) {
      for (; next != blocks.end() && next->row == row && next->column < matrix.columns[k]; ++next)
        append(next->column, next->stiffness.data());
      append(matrix.columns[k], matrix.values.data() + 9 * k);
    }
    for (; next != blocks.end() && next->row == row; ++next) append(next->column, next->stiffness.data());
    merged.first.push_back(merged.columns.size());
  }
  return merged;
}

std::vector<NodeBlock> symmetric_halves(const std::vector<NodeBlock>& blocks) {
  std::vector<NodeBlock> all;
  for (const NodeBlock& block : blocks) {
    all.push_back({block.row, block.column, 0.5 * block.stiffness});
    all.push_back({block.column, block.row, 0.5 * block.stiffness.transpose()});
  }
  const auto key = [](const NodeBlock& block) { return std::tie(block.row, block.column); };
  std::stable_sort(all.begin(), all.end(),
                   [&](const NodeBlock& a, const NodeBlock& b) { return key(a) < key(b); });
  std::vector<NodeBlock> sums;
  for (const NodeBlock& block : all) {
    if (!sums.empty() && key(sums.back()) == key(block))
      sums.back().stiffness += block.stiffness;
    else
      sums.push_back(block);
  }
  return sums;
}

BlockMatrix<3, 3> without_moved(const BlockMatrix<3, 3>& matrix, const StaticBodies& bodies) {
  BlockMatrix<3, 3> left;
  left.n_columns = matrix.n_columns;
  left.first.push_back(0);
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) {
    for (std::size_t k = matrix.first[row]; k < matrix.first[row + std::size_t{1}]; ++k) {
      if (bodies.moves(row) || bodies.moves(matrix.columns[k])) continue;
      left.columns.push_back(matrix.columns[k]);
      left.values.insert(left.values.end(), matrix.values.begin() + static_cast<std::ptrdiff_t>(9 * k),
                         matrix.values.begin() + static_cast<std::ptrdiff_t>(9 * k + 9));
    }
    left.first.push_back(left.columns.size());
  }
  return left;
}

}  // namespace contactsim
