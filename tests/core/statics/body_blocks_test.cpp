// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/body_blocks.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const Eigen::Matrix3d some_stiffness = (Eigen::Matrix3d() << 1, 2, 3, 4, 5, 6, 7, 8, 10).finished();

}  // namespace

TEST_CASE("stiffness between the nodes of one body is summed in its block, others are refused",
          "[core][statics]") {
  const CappedCube cube;
  BodyBlocks blocks(*cube.problem);
  const std::uint32_t centre = cube.problem->bodies().centre_node(0), turning = centre + 1;
  CHECK(blocks.of(0).isZero(0.0));  // no forces yet
  CHECK_FALSE(blocks.add(3, centre, some_stiffness));
  CHECK_FALSE(blocks.add(centre, 3, some_stiffness));
  CHECK_FALSE(blocks.add(26, 26, some_stiffness));
  CHECK(blocks.of(0).isZero(0.0));
  CHECK(blocks.add(centre, centre, some_stiffness));
  CHECK(blocks.add(centre, turning, 2.0 * some_stiffness));
  CHECK(blocks.add(turning, centre, 3.0 * some_stiffness));
  CHECK(blocks.add(turning, turning, 4.0 * some_stiffness));
  CHECK(blocks.add(turning, turning, 4.0 * some_stiffness));
  Eigen::Matrix<double, 6, 6> expected;
  expected << some_stiffness, 2.0 * some_stiffness, 3.0 * some_stiffness, 8.0 * some_stiffness;
  CHECK(blocks.of(0) == expected);
}

TEST_CASE("blocks begin with what forces do as bodies turn", "[core][statics]") {
  CappedCube cube;
  cube.load.force = {3e9, -2e9, 5e9};
  Eigen::VectorXd residual;
  REQUIRE(cube.problem->evaluate(cube.still(), residual));
  BodyBlocks blocks(*cube.problem);
  CHECK(blocks.of(0).bottomRightCorner<3, 3>() == cube.problem->bodies().turning_stiffness(0));
  CHECK(blocks.of(0).bottomRightCorner<3, 3>().norm() > 1e8);
  CHECK(blocks.of(0).topRows<3>().isZero(0.0));
}

TEST_CASE("held directions of a body, displacements and rotations, are taken off", "[core][statics]") {
  CappedCube cube;
  PrescribedMotion hold;
  hold.direction = Components{{false, true, false}};
  hold.nodes = {NodeIndex{0}};
  cube.model.rigid.kinematic_constraints = KinematicConstraints(*cube.model.rigid.nodes.references, {hold});
  hold.direction = Components{{true, false, true}};
  cube.model.rigid.rotation_constraints = KinematicConstraints(*cube.model.rigid.nodes.references, {hold});
  cube.problem->begin_step(1.0);
  BodyBlocks blocks(*cube.problem);
  blocks.of(0).setConstant(7.0);
  blocks.project();
  Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Constant(7.0);
  for (const Eigen::Index held : {1, 3, 5}) {
    expected.row(held).setZero();
    expected.col(held).setZero();
  }
  CHECK(blocks.of(0) == expected);
}
