// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/tangent_probe.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"
#include "support/trial_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("columns are derivatives of the residual, one evaluation for an unknown of a colour",
          "[core][statics]") {
  StaticCube cube({NodeIndex{4}});
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  TangentProbe probe(*cube.problem, graph, ColourDistance::two_elements);
  CHECK(probe.n_nodes() == 27);
  CHECK(probe.unknowns_per_node() == 3);
  CHECK(probe.place(5, 2) == 17);
  const Eigen::VectorXd at = cube.pulled(1e-3);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(81, 81);
  const std::int64_t n =
      probe.differentiate(at, [&](std::uint32_t node, Eigen::Index unknown, const Eigen::VectorXd& column) {
        stiffness.col(3 * node + unknown) =
            column;  // in a mesh of two cells each way all nodes are neighbours
      });
  CHECK(n == 1 + 3 * 27);
  // By a central difference along another direction.
  Eigen::VectorXd way = cube.pulled(1e-7).reverse(), before, after;
  cube.problem->project(way);
  REQUIRE(cube.problem->evaluate(at - way, before));
  REQUIRE(cube.problem->evaluate(at + way, after));
  const Eigen::VectorXd expected = 0.5 * (before - after);
  CHECK((stiffness * way - expected).norm() < 1e-5 * expected.norm());
  CHECK(stiffness.middleRows<3>(12).isZero(0.0));  // the held node
  CHECK(stiffness.middleCols<3>(12).isZero(0.0));
}

TEST_CASE("no residual at the increment, no columns", "[core][statics]") {
  StaticCube cube;
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  TangentProbe probe(*cube.problem, graph, ColourDistance::one_element);
  int n_columns = 0;
  const auto count = [&](std::uint32_t, Eigen::Index, const Eigen::VectorXd&) { ++n_columns; };
  CHECK(probe.differentiate(cube.pulled(-3.0), count) == 0);
  CHECK(n_columns == 0);
  CHECK(probe.differentiate(cube.pulled(0.0), count) == 1 + 3 * 8);
  CHECK(n_columns == 81);
}

TEST_CASE("contact is left out of the columns and follows again afterwards", "[core][statics]") {
  StaticCube cube;
  TrialContact contact(cube.mesh.coordinates());
  contact.springs = {spring_between(0, 26, 1e15 * Eigen::Matrix3d::Identity())};
  StaticProblem problem(cube.model, ForceTerms{*cube.internal, cube.nothing, &contact}, &contact,
                        ResidualReference::internal, cube.state);
  problem.begin_step(1.0);
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  TangentProbe probe(problem, graph, ColourDistance::one_element);
  double largest = 0.0;
  probe.differentiate(cube.pulled(0.0), [&](std::uint32_t, Eigen::Index, const Eigen::VectorXd& column) {
    largest = std::max(largest, column.cwiseAbs().maxCoeff());
  });
  CHECK(largest < 1e13);  // the elements' is some modulus times edge, 1e11
  CHECK(contact.n_trials == 1);
  Eigen::VectorXd residual;
  REQUIRE(problem.evaluate(cube.pulled(1e-6), residual));
  CHECK(contact.n_trials == 2);
}

TEST_CASE("nodes of rigid bodies are moved as if they were free", "[core][statics]") {
  CappedCube cube;
  TangentProbe probe(*cube.problem, cube.graph(), ColourDistance::one_element);
  CHECK(probe.n_nodes() == 27 + 2);
  std::vector<int> n_columns(29, 0);
  probe.differentiate(cube.still(), [&](std::uint32_t node, Eigen::Index, const Eigen::VectorXd& column) {
    ++n_columns[node];
    CHECK((column.segment<3>(3 * Eigen::Index{node}).norm() > 0.0) ==
          (cube.mesh.coordinates()(2, node) > 0.0));
  });
  CHECK(n_columns == std::vector<int>{3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
                                      3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 0, 0});
}
