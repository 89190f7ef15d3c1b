// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/tangent_blocks.hpp"

#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

NodeGraph graph_of(const StaticCube& cube) {
  return NodeGraph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
}

/// The stiffness as visit() shows it.
Eigen::MatrixXd visited(const TangentBlocks& blocks, Eigen::Index size) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  blocks.visit([&](std::uint32_t row, std::uint32_t column, const double* block) {
    dense.block<3, 3>(3 * row, 3 * column) += Eigen::Map<const Eigen::Matrix3d>(block);
  });
  return dense;
}

Eigen::MatrixXd dense_of(const BlockMatrix<3, 3>& matrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * matrix.n_rows(), 3 * matrix.n_columns);
  for (std::uint32_t row = 0; row < matrix.n_rows(); ++row) {
    CHECK(std::is_sorted(matrix.columns_of(row).begin(), matrix.columns_of(row).end()));
    for (const std::uint32_t column : matrix.columns_of(row))
      dense.block<3, 3>(3 * row, 3 * column) += matrix.block(matrix.place_of(row, column));
  }
  return dense;
}

/// Springs between nodes at two edges of the cube, which share no element, and between neighbours. As contact
/// gives them: not symmetric.
std::vector<NodeBlock> springs() {
  Eigen::Matrix3d spring;
  spring << 4.0, 1.0, 0.0, 0.5, 3.0, 0.0, 0.0, 0.2, 5.0;
  spring *= 1e11;
  return {{0, 0, spring},  {0, 26, -spring}, {26, 0, -spring}, {26, 26, spring},
          {8, 20, spring}, {13, 14, spring}, {8, 20, spring}};
}

}  // namespace

TEST_CASE("blocks are the derivatives of the residual", "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph = graph_of(cube);
  TangentBlocks blocks(*cube.problem, graph);
  const Eigen::Index size = cube.problem->size();
  REQUIRE(blocks.renew(Eigen::VectorXd::Zero(size)) > 0);
  const Eigen::MatrixXd stiffness = visited(blocks, size);
  const Eigen::VectorXd increment = cube.pulled(1e-9);
  Eigen::VectorXd residual;
  REQUIRE(cube.problem->evaluate(increment, residual));
  CHECK((stiffness * increment + residual).norm() < 1e-5 * residual.norm());
}

TEST_CASE("blocks between nodes that share no element come beside those of the mesh", "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph = graph_of(cube);
  TangentBlocks blocks(*cube.problem, graph);
  const Eigen::Index size = cube.problem->size();
  REQUIRE(blocks.renew(Eigen::VectorXd::Zero(size)) > 0);
  Eigen::MatrixXd expected = visited(blocks, size);
  blocks.join(springs());
  for (const NodeBlock& part : springs())
    expected.block<3, 3>(3 * part.row, 3 * part.column) += part.stiffness;
  CHECK((visited(blocks, size) - expected).norm() < 1e-14 * expected.norm());
  const Eigen::MatrixXd symmetric = 0.5 * (expected + expected.transpose());
  CHECK((dense_of(blocks.take_symmetric(true)) - symmetric).norm() < 1e-14 * symmetric.norm());
}

TEST_CASE("shares of their stiffness hold nodes to the ground, and are reported", "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph = graph_of(cube);
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(cube.problem->size());
  TangentBlocks alone(*cube.problem, graph), held(*cube.problem, graph, 1e-3);
  std::vector<double> shares(graph.n_nodes(), 0.0);
  REQUIRE(alone.update(still, shares, false).exists);
  CHECK(alone.ground().size() == 0);
  shares[5] = 0.01;
  REQUIRE(held.update(still, shares, false).exists);
  const Eigen::MatrixXd stiffness = visited(alone, still.size());
  Eigen::VectorXd expected = 1e-3 * stiffness.diagonal();
  expected.segment<3>(15) += 0.01 * stiffness.diagonal().segment<3>(15);
  CHECK((held.ground() - expected).norm() < 1e-9 * expected.norm());
  const Eigen::MatrixXd added = visited(held, still.size()) - stiffness;
  CHECK((added.diagonal() - expected).norm() < 1e-6 * expected.norm());
}

TEST_CASE("nothing joins held nodes to others", "[core][statics]") {
  StaticCube cube({NodeIndex{0}, NodeIndex{13}});
  const NodeGraph graph = graph_of(cube);
  TangentBlocks blocks(*cube.problem, graph);
  REQUIRE(blocks.renew(Eigen::VectorXd::Zero(cube.problem->size())) > 0);
  blocks.join(springs());
  const Eigen::MatrixXd stiffness = dense_of(blocks.take_symmetric(false));
  for (const Eigen::Index node : {0, 13}) {
    Eigen::MatrixXd rows = stiffness.middleRows<3>(3 * node);
    CHECK(rows.middleCols<3>(3 * node).diagonal().minCoeff() > 0.0);
    rows.middleCols<3>(3 * node).setZero();
    CHECK(rows.isZero(0.0));
  }
  CHECK(stiffness.block<3, 3>(3 * 8, 3 * 20).norm() > 0.0);
}

TEST_CASE("the stiffness of the mesh stays where it may", "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph = graph_of(cube);
  TangentBlocks blocks(*cube.problem, graph);
  const Eigen::VectorXd at = cube.pulled(0.1);
  const TangentBlocks::Update first = blocks.update(at, {}, true);
  CHECK(first.exists);
  CHECK(first.has_new_elements);  // none before
  const Eigen::VectorXd moved = cube.pulled(0.2);
  const TangentBlocks::Update kept = blocks.update(moved, {}, true);
  CHECK(kept.exists);
  CHECK_FALSE(kept.has_new_elements);
  CHECK(kept.n_evaluations == 1);
  CHECK(blocks.update(moved, {}, false).n_evaluations == first.n_evaluations);
  const TangentBlocks::Update inside_out = blocks.update(cube.pulled(-3.0), {}, true);
  CHECK_FALSE(inside_out.exists);
  CHECK(inside_out.n_evaluations == 1);
}

TEST_CASE("blocks that are kept are those from before springs came to them", "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph = graph_of(cube);
  TangentBlocks blocks(*cube.problem, graph);
  const Eigen::VectorXd at = Eigen::VectorXd::Zero(cube.problem->size());
  REQUIRE(blocks.update(at, {}, false).exists);
  const Eigen::MatrixXd alone = dense_of(blocks.take_symmetric(true));
  REQUIRE(blocks.update(at, {}, true).n_evaluations == 1);
  blocks.join(springs());
  CHECK((dense_of(blocks.take_symmetric(true)) - alone).norm() > 1e-3 * alone.norm());
  REQUIRE(blocks.update(at, {}, true).n_evaluations == 1);
  CHECK(dense_of(blocks.take_symmetric(false)) == alone);
}
