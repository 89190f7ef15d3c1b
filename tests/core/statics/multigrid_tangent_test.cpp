// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid_tangent.hpp"

#include "core/statics/full_tangent.hpp"
#include "core/statics/newton.hpp"
#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::vector<NodeIndex> nodes_below(std::uint32_t n) {
  std::vector<NodeIndex> nodes;
  for (std::uint32_t node = 0; node < n; ++node) nodes.push_back({node});
  return nodes;
}

Eigen::VectorXd some_force(StaticProblem& problem) {
  Eigen::VectorXd force = Eigen::ArrayXd::LinSpaced(problem.size(), 0.0, 30.0).sin();
  problem.project(force);
  return force;
}

}  // namespace

TEST_CASE("minimal residuals with multigrid find what a factor does", "[core][statics]") {
  StaticCube cube(nodes_below(40), 8);
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  const FullTangentSettings settings;
  FullTangent factor(*cube.problem, graph, settings);
  MultigridTangent multigrid(*cube.problem, graph, settings);
  CHECK_FALSE(multigrid.exists());
  const Eigen::VectorXd at = cube.pulled(0.0);
  CHECK(factor.renew(at) == multigrid.renew(at));
  REQUIRE(factor.exists());
  REQUIRE(multigrid.exists());
  Eigen::VectorXd exact, near, base;
  const Eigen::VectorXd force = some_force(*cube.problem);
  factor.apply(force, exact);
  REQUIRE(cube.problem->evaluate(at, base));
  LinearisedEquilibrium linearised(*cube.problem, multigrid,
                                   [&](const Eigen::VectorXd&, bool) { FAIL("needs no other"); });
  CgReport report;
  linearised.solve(at, base, force, report, near);
  CHECK((near - exact).norm() < 1e-2 * exact.norm());
  CHECK(report.n_linear > 3);
  CHECK(report.n_linear < 20);
  CHECK(report.n_evaluations == report.n_linear);
  CHECK_FALSE(report.meets_negative);
}

TEST_CASE("what cannot be evaluated leaves the multigrid as it is", "[core][statics]") {
  StaticCube cube(nodes_below(9), 2);
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  const FullTangentSettings settings;
  MultigridTangent multigrid(*cube.problem, graph, settings);
  REQUIRE(multigrid.renew(cube.pulled(0.0)) > 0);
  Eigen::VectorXd before, after;
  const Eigen::VectorXd force = some_force(*cube.problem);
  multigrid.apply(force, before);
  CHECK(multigrid.renew(cube.pulled(-3.0)) == 1);  // which tells
  multigrid.apply(force, after);
  CHECK(before == after);
}
