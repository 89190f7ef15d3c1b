// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_problem.hpp"

#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("trials leave no trace in elements", "[core][statics]") {
  StaticCube cube;
  Eigen::VectorXd first, second, other;
  const Eigen::VectorXd small = cube.pulled(1e-3), large = cube.pulled(0.2);
  REQUIRE(cube.problem->evaluate(small, first));
  REQUIRE(cube.problem->evaluate(large, other));
  REQUIRE(cube.problem->evaluate(small, second));
  CHECK(first == second);
  cube.problem->restore();
  CHECK(cube.state.coordinates == cube.mesh.coordinates());
}

TEST_CASE("elements that turn inside out have no forces", "[core][statics]") {
  StaticCube cube;
  Eigen::VectorXd residual;
  CHECK_FALSE(cube.problem->evaluate(cube.pulled(-3.0), residual));
  CHECK(cube.problem->evaluate(cube.pulled(-0.1), residual));
}

TEST_CASE("the work of an accepted increment is that of the mean force", "[core][statics]") {
  StaticCube cube;
  const Eigen::VectorXd increment = cube.pulled(1e-6);
  Eigen::VectorXd residual;
  REQUIRE(cube.problem->evaluate(increment, residual));
  cube.problem->accept(increment);
  // Energy of a homogeneous strain e (1, -0.3, 0.2), K and G: V (K tr^2 / 2 + G dev:dev), V = 8.
  const double e = 1e-6;
  const Eigen::Vector3d strain = e * Eigen::Vector3d(1.0, -0.3, 0.2);
  const double trace = strain.sum();
  const Eigen::Vector3d deviator = strain.array() - trace / 3.0;
  const double energy = 8.0 * (0.5 * 160e9 * trace * trace + 80e9 * deviator.squaredNorm());
  CHECK(cube.state.energies.internal == Approx(energy).epsilon(1e-5));
}
