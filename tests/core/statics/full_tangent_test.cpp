// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/full_tangent.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a factor of the whole stiffness undoes it", "[core][statics]") {
  StaticCube cube({NodeIndex{0}, NodeIndex{2}, NodeIndex{6}});
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  const FullTangentSettings settings;
  FullTangent tangent(*cube.problem, graph, settings);
  CHECK(tangent.renew(Eigen::VectorXd::Zero(cube.problem->size())) > 81);
  REQUIRE(tangent.exists());
  Eigen::VectorXd increment = cube.pulled(1e-9), residual, found;
  cube.problem->project(increment);
  REQUIRE(cube.problem->evaluate(increment, residual));
  tangent.apply(-residual, found);
  CHECK((found - increment).norm() < 1e-4 * increment.norm());
}

TEST_CASE("a factor with a rigid body undoes its stiffness", "[core][statics]") {
  CappedCube cube;
  cube.load.force = {3e9, -2e9, 5e9};
  const NodeGraph graph = cube.graph();
  const FullTangentSettings settings;
  FullTangent tangent(*cube.problem, graph, settings);
  tangent.set_free(std::vector<double>(graph.n_nodes(), 0.0));
  tangent.renew(cube.still());
  REQUIRE(tangent.exists());
  Eigen::VectorXd increment = 1e-6 * cube.turned(1.0), residual, base, found;
  increment(3 * 13) = 1e-6;  // of the node in the middle
  REQUIRE(cube.problem->evaluate(cube.still(), base));
  REQUIRE(cube.problem->evaluate(increment, residual));
  tangent.apply(base - residual, found);
  CHECK((found - increment).norm() < 1e-4 * increment.norm());
}

TEST_CASE("nodes without elements have no part in the factor, held ones stay", "[core][statics]") {
  // The last node is of no element.
  MeshBuilder builder;
  builder.add_hexes({.cells = {1, 1, 1}}).add_node({9, 9, 9});
  const Mesh mesh = builder.build();
  StaticCube cube({NodeIndex{0}, NodeIndex{1}, NodeIndex{2}}, 1);
  Model model = std::move(cube.model);
  model.mesh = &mesh;
  model.mass = Eigen::RowVectorXd::Ones(9);
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  InternalForce internal(model, state);
  StaticProblem problem(model, ForceTerms{internal, cube.nothing}, nullptr, ResidualReference::internal,
                        state);
  problem.begin_step(1.0);
  const NodeGraph graph(mesh.n_nodes(), mesh, model.blocks);
  FullTangent tangent(problem, graph, {});
  CHECK_FALSE(tangent.exists());
  CHECK(tangent.n_negative() == 0);
  tangent.renew(Eigen::VectorXd::Zero(27));
  REQUIRE(tangent.exists());
  Eigen::VectorXd z;
  tangent.apply(Eigen::VectorXd::Constant(27, 1e3), z);
  CHECK(z.tail<3>().isZero(0.0));
  CHECK(z.head<9>().isZero(0.0));
  CHECK(z.segment<15>(9).norm() > 1e-9);
}

TEST_CASE("a factor that cannot be renewed stays as it was", "[core][statics]") {
  StaticCube cube({NodeIndex{0}, NodeIndex{2}, NodeIndex{6}});
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  FullTangent tangent(*cube.problem, graph, {});
  REQUIRE(tangent.renew(cube.pulled(0.0)) > 1);
  const Eigen::VectorXd force = cube.pulled(1e6);
  Eigen::VectorXd before, after;
  tangent.apply(force, before);
  CHECK(tangent.renew(cube.pulled(-3.0)) == 1);
  tangent.apply(force, after);
  CHECK(before == after);
}

TEST_CASE("a cube that is pressed far has directions of negative stiffness, at rest none",
          "[core][statics]") {
  StaticCube cube({NodeIndex{0}, NodeIndex{2}, NodeIndex{6}});
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  FullTangent tangent(*cube.problem, graph, {});
  tangent.renew(cube.pulled(0.0));
  CHECK(tangent.n_negative() == 0);
  tangent.renew(cube.pulled(-0.8));
  CHECK(tangent.n_negative() > 0);
}
