// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_bodies.hpp"

#include "core/statics/full_tangent.hpp"
#include "core/statics/multigrid_tangent.hpp"
#include "core/statics/newton.hpp"
#include "support/capped_cube.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("forces on a rigid body do the work of those on its nodes", "[core][statics]") {
  CappedCube cube;
  cube.load.force = {3e9, -2e9, 5e9};
  for (const double angle : {0.0, 1e-4, 0.2}) {
    const Eigen::VectorXd at = cube.turned(angle);
    Eigen::VectorXd residual, forces, moved;
    REQUIRE(cube.problem->evaluate_nodes(at, forces));
    for (Eigen::Index i = 0; i < 6; ++i) {
      constexpr double h = 1e-6;
      Eigen::VectorXd change = cube.still();
      change(cube.centre() + i) = h;
      REQUIRE(cube.problem->evaluate(at - change, moved));
      const Eigen::Matrix3Xd before = cube.state.coordinates;
      REQUIRE(cube.problem->evaluate(at + change, moved));
      const Eigen::Matrix3Xd way = (cube.state.coordinates - before) / (2.0 * h);
      REQUIRE(cube.problem->evaluate(at, residual));
      const double work = forces.head(way.size()).dot(way.reshaped());
      CHECK(residual(cube.centre() + i) == Approx(work).epsilon(1e-6).margin(1e-6 * forces.norm()));
    }
    for (const NodeIndex node : cube.model.rigid.bodies[0].nodes)
      CHECK(residual.segment<3>(3 * Eigen::Index{node.value}).isZero(0.0));
  }
}

TEST_CASE("what forces do as a rigid body turns is in its stiffness", "[core][statics]") {
  CappedCube cube;
  cube.load.force = {3e9, -2e9, 5e9};
  Eigen::VectorXd base, there, back;
  REQUIRE(cube.problem->evaluate(cube.still(), base));
  const Eigen::Matrix3d stiffness = cube.problem->bodies().turning_stiffness(0);
  for (Eigen::Index i = 0; i < 3; ++i) {
    constexpr double h = 1e-5;
    Eigen::VectorXd change = cube.still();
    change(cube.centre() + 3 + i) = h;
    REQUIRE(cube.problem->evaluate(change, there));
    REQUIRE(cube.problem->evaluate(-change, back));
    const Eigen::Vector3d column = (back - there).segment<3>(cube.centre() + 3) / (2.0 * h);
    // Elements resist, too.
    cube.load.force.setZero();
    REQUIRE(cube.problem->evaluate(change, there));
    REQUIRE(cube.problem->evaluate(-change, back));
    const Eigen::Vector3d of_elements = (back - there).segment<3>(cube.centre() + 3) / (2.0 * h);
    cube.load.force = {3e9, -2e9, 5e9};
    CHECK((column - of_elements - stiffness.col(i)).norm() < 1e-4 * stiffness.norm());
  }
}

TEST_CASE("trials of rigid bodies leave no trace", "[core][statics]") {
  CappedCube cube;
  Eigen::VectorXd residual;
  REQUIRE(cube.problem->evaluate(cube.turned(0.3), residual));
  CHECK(cube.state.rigid[0].angle.norm() > 0.05);
  cube.problem->restore();
  CHECK(cube.state.coordinates == cube.mesh.coordinates());
  CHECK(cube.state.rigid[0].position == cube.model.rigid.bodies[0].centre);
  CHECK(cube.state.rigid[0].angle.isZero(0.0));
}

TEST_CASE("conditions move rigid bodies, which then take part in multigrid, too", "[core][statics]") {
  CappedCube cube(true);
  const Eigen::VectorXd prescribed = cube.problem->prescribed();
  CHECK(prescribed(cube.centre()) == Approx(1e-4));
  CHECK(prescribed.norm() == Approx(1e-4));
  CHECK_FALSE(cube.problem->bodies().are_free());
  CHECK(CappedCube().problem->bodies().are_free());
  Eigen::VectorXd residual, by_factor, by_multigrid;
  REQUIRE(cube.problem->evaluate(prescribed, residual));
  const NodeGraph graph = cube.graph();
  const FullTangentSettings settings;
  FullTangent factor(*cube.problem, graph, settings);
  MultigridTangent multigrid(*cube.problem, graph, settings);
  factor.renew(cube.still());
  multigrid.renew(cube.still());
  factor.apply(residual, by_factor);
  LinearisedEquilibrium linearised(*cube.problem, multigrid, [](const Eigen::VectorXd&, bool) {});
  CgReport report;
  linearised.solve(prescribed, residual, residual, report, by_multigrid);
  CHECK(by_factor.norm() > 1e-6);
  CHECK((by_factor - by_multigrid).norm() < 2e-3 * by_factor.norm());
  CHECK(by_factor.segment<6>(cube.centre()).isZero(0.0));
}
