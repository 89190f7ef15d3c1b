// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/node_block.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"
#include "support/trial_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const Eigen::Matrix3d slanted = (Eigen::Matrix3d() << 4, 1, 0, 3, 5, 2, 0, 0, 6).finished();

/// Blocks that are n times the unit matrix at (row, column) of three nodes: 1 at (0, 0), 2 at (0, 2), 3 at
/// (2, 2).
BlockMatrix<3, 3> some_matrix() {
  BlockMatrix<3, 3> matrix;
  matrix.n_columns = 3;
  matrix.first = {0, 2, 2, 3};
  matrix.columns = {0, 2, 2};
  for (const double n : {1.0, 2.0, 3.0}) {
    const Eigen::Matrix3d block = n * Eigen::Matrix3d::Identity();
    matrix.values.insert(matrix.values.end(), block.data(), block.data() + 9);
  }
  return matrix;
}

}  // namespace

TEST_CASE("a spring between two nodes has four blocks", "[core][statics]") {
  const std::vector<NodeBlock> blocks = blocks_of({spring_between(3, 8, slanted)});
  REQUIRE(blocks.size() == 4);
  for (const NodeBlock& block : blocks)
    CHECK(block.stiffness == (block.row == block.column ? slanted : Eigen::Matrix3d(-slanted)));
}

TEST_CASE("halves of blocks and of their transposes come by rows, each once", "[core][statics]") {
  const std::vector<NodeBlock> halves = symmetric_halves({{2, 0, slanted}, {0, 2, slanted}, {1, 1, slanted}});
  REQUIRE(halves.size() == 3);
  const Eigen::Matrix3d sum = 0.5 * (slanted + slanted.transpose());
  const std::uint32_t rows[] = {0, 1, 2}, columns[] = {2, 1, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(halves[i].row == rows[i]);
    CHECK(halves[i].column == columns[i]);
    CHECK(halves[i].stiffness == sum);
  }
}

TEST_CASE("blocks come between those of a matrix", "[core][statics]") {
  const BlockMatrix<3, 3> all =
      with_blocks(some_matrix(), {{0, 1, slanted}, {1, 0, slanted}, {2, 0, slanted}});
  CHECK(all.first == std::vector<std::size_t>{0, 3, 4, 6});
  CHECK(all.columns == std::vector<std::uint32_t>{0, 1, 2, 0, 0, 2});
  for (const std::size_t place : {1, 3, 4}) CHECK(all.block(place) == slanted);
  CHECK(all.block(2) == 2.0 * Eigen::Matrix3d::Identity());
  CHECK(all.block(5) == 3.0 * Eigen::Matrix3d::Identity());
}

TEST_CASE("a matrix loses the rows and columns of nodes that rigid bodies move", "[core][statics]") {
  const CappedCube cube;
  const StaticBodies& bodies = cube.problem->bodies();
  const std::uint32_t moved = cube.model.rigid.bodies[0].nodes[0].value;
  REQUIRE_FALSE(bodies.moves(0));
  BlockMatrix<3, 3> matrix;
  matrix.n_columns = bodies.n_nodes();
  matrix.first.assign(bodies.n_nodes() + std::size_t{1}, 0);
  const auto add = [&](std::uint32_t row, std::uint32_t column) {
    for (std::size_t i = row + std::size_t{1}; i < matrix.first.size(); ++i) ++matrix.first[i];
    matrix.columns.push_back(column);
    matrix.values.insert(matrix.values.end(), slanted.data(), slanted.data() + 9);
  };
  add(0, 0);
  add(0, moved);
  add(moved, 0);
  add(bodies.centre_node(0), bodies.centre_node(0));
  const BlockMatrix<3, 3> left = without_moved(matrix, bodies);
  CHECK(left.n_rows() == matrix.n_rows());
  CHECK(left.columns == std::vector<std::uint32_t>{0, bodies.centre_node(0)});
  CHECK(left.columns_of(moved).empty());
  CHECK(left.block(1) == slanted);
}
