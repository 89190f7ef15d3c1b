// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/nodal_blocks.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("nodal blocks are those of the whole stiffness", "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  NodalBlocks blocks(*cube.problem, graph);
  CHECK(blocks.renew(Eigen::VectorXd::Zero(cube.problem->size())) == 1 + 3 * 8);
  // The force that moves one node alone, at that node, comes back as its displacement.
  for (const Eigen::Index unknown : {0, 40, 80}) {
    Eigen::VectorXd increment = Eigen::VectorXd::Zero(cube.problem->size()), residual, z;
    increment(unknown) = 1e-9;
    REQUIRE(cube.problem->evaluate(increment, residual));
    const Eigen::Index node = unknown / 3;
    Eigen::VectorXd own = Eigen::VectorXd::Zero(residual.size());
    own.segment<3>(3 * node) = -residual.segment<3>(3 * node);
    blocks.apply(own, z);
    CHECK((z - increment).norm() < 1e-5 * increment.norm());
  }
}

TEST_CASE("nodal blocks have those of rigid bodies", "[core][statics]") {
  CappedCube cube;
  const NodeGraph graph = cube.graph();
  NodalBlocks blocks(*cube.problem, graph);
  CHECK(blocks.renew(cube.still()) == 1 + 3 * 8);
  Eigen::VectorXd residual, z;
  REQUIRE(cube.problem->evaluate(1e-6 * cube.turned(1.0), residual));
  blocks.apply(residual, z);
  CHECK(z.dot(residual) > 0.0);
  CHECK(z.segment<6>(cube.centre()).norm() > 1e-8);
  for (const NodeIndex node : cube.model.rigid.bodies[0].nodes)
    CHECK(z.segment<3>(3 * Eigen::Index{node.value}).isZero(0.0));
}

TEST_CASE("blocks that cannot be found leave those before, before the first nothing moves",
          "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  NodalBlocks blocks(*cube.problem, graph);
  const Eigen::VectorXd force = cube.pulled(1e6);
  Eigen::VectorXd before, after;
  blocks.apply(force, before);
  CHECK(before.isZero(0.0));
  CHECK(blocks.largest() == 0.0);
  REQUIRE(blocks.renew(cube.pulled(0.0)) > 1);
  blocks.apply(force, before);
  const double largest = blocks.largest();
  CHECK(blocks.renew(cube.pulled(-3.0)) == 0);
  blocks.apply(force, after);
  CHECK(before == after);
  CHECK(blocks.largest() == largest);
}

TEST_CASE("held nodes get no motion, the others one that works with the force", "[core][statics]") {
  StaticCube cube({NodeIndex{0}, NodeIndex{13}});
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  NodalBlocks blocks(*cube.problem, graph);
  blocks.renew(cube.pulled(0.0));
  Eigen::VectorXd force = Eigen::ArrayXd::LinSpaced(cube.problem->size(), 0.0, 30.0).sin(), z;
  cube.problem->project(force);
  blocks.apply(force, z);
  for (Eigen::Index node = 0; node < 27; ++node) {
    const double work = force.segment<3>(3 * node).dot(z.segment<3>(3 * node));
    CHECK((node == 0 || node == 13 ? z.segment<3>(3 * node).isZero(0.0) : work > 0.0));
  }
}
