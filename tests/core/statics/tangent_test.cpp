// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/tangent.hpp"

#include "core/materials/elastic.hpp"
#include "core/statics/multigrid_tangent.hpp"
#include "support/capped_cube.hpp"
#include "support/catch.hpp"
#include "support/trial_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

LinearSolverChoice choose(const StaticProblem& problem, const NodeGraph& graph, LinearSolver asked) {
  return choose_linear_solver(problem, graph, asked);
}

}  // namespace

TEST_CASE("large solids are for multigrid, unless the deck says otherwise", "[core][statics]") {
  StaticCube small, large({}, 17);
  const NodeGraph small_graph(small.mesh.n_nodes(), small.mesh, small.model.blocks);
  const NodeGraph large_graph(large.mesh.n_nodes(), large.mesh, large.model.blocks);
  CHECK(choose(*small.problem, small_graph, LinearSolver::automatic).solver == LinearSolver::direct);
  CHECK(choose(*small.problem, small_graph, LinearSolver::automatic).reason ==
        "there are at most 5000 nodes");
  CHECK(choose(*large.problem, large_graph, LinearSolver::automatic).solver == LinearSolver::multigrid);
  CHECK(choose(*large.problem, large_graph, LinearSolver::direct).solver == LinearSolver::direct);
  CHECK(choose(*small.problem, small_graph, LinearSolver::multigrid).solver == LinearSolver::multigrid);
  CHECK(choose(*small.problem, small_graph, LinearSolver::multigrid).reason.empty());
  FullTangentSettings settings;
  settings.linear_solver = LinearSolver::multigrid;
  const auto made = make_tangent(*small.problem, small_graph, settings);
  CHECK(dynamic_cast<MultigridTangent*>(made.get()) != nullptr);
}

TEST_CASE("rigid bodies that are not wholly moved, and what turns, take a factor", "[core][statics]") {
  const CappedCube free, driven(true);
  const NodeGraph free_graph = free.graph(), driven_graph = driven.graph();
  const LinearSolverChoice left_open = choose(*free.problem, free_graph, LinearSolver::automatic);
  CHECK(left_open.solver == LinearSolver::direct);
  CHECK(left_open.is_asked_for);
  CHECK(left_open.reason == "a rigid body is not wholly held and prescribed");
  const LinearSolverChoice other = choose(*free.problem, free_graph, LinearSolver::multigrid);
  CHECK(other.solver == LinearSolver::direct);
  CHECK_FALSE(other.is_asked_for);
  CHECK(other.reason == left_open.reason);
  // A velocity is prescribed in that step, but not all the time.
  CHECK(choose(*driven.problem, driven_graph, LinearSolver::direct).reason.empty());

  const Mesh mesh = MeshBuilder().add_shells({.cells = {2, 2}}).build();
  Model model;
  model.mesh = &mesh;
  const std::vector<double> thickness(4, 0.1);
  ElementProperties properties{ElasticLaw{{160e9, 80e9}}, 7800.0};
  model.blocks.push_back(make_shell_block(mesh, 0, shell4_bt_shell, properties, {}, thickness));
  model.mass = lumped_mass(mesh, model.blocks);
  model.inertia = lumped_inertia(mesh, model.blocks);
  State state = make_state(mesh.coordinates(), model.blocks, 0.0);
  InternalForce internal(model, state);
  NoLoad nothing;
  const StaticProblem problem(model, ForceTerms{internal, nothing}, nullptr, ResidualReference::internal,
                              state);
  const NodeGraph graph(mesh.n_nodes(), mesh, model.blocks);
  CHECK(choose(problem, graph, LinearSolver::automatic).reason == "nodes of shells or beams turn");
  CHECK(choose(problem, graph, LinearSolver::multigrid).solver == LinearSolver::direct);
}

TEST_CASE("a tangent follows springs that change far at once, others when it is to catch up",
          "[core][statics]") {
  StaticCube cube({NodeIndex{0}, NodeIndex{2}, NodeIndex{6}});
  TrialContact contact(cube.mesh.coordinates());
  const Eigen::Matrix3d stiffness = 1e12 * Eigen::Matrix3d::Identity();
  contact.springs = {spring_between(8, 26, stiffness)};
  StaticProblem problem(cube.model, ForceTerms{*cube.internal, cube.nothing, &contact}, &contact,
                        ResidualReference::internal, cube.state);
  problem.begin_step(1.0);
  const NodeGraph graph(cube.mesh.n_nodes(), cube.mesh, cube.model.blocks);
  const auto tangent = make_tangent(problem, graph, {});
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.size());
  const std::int64_t n_all = tangent->renew(still);
  CHECK(tangent->exists());
  CHECK_FALSE(tangent->catch_up());

  // What a force on a node does against the spring; the tangent is right when that comes back.
  Eigen::VectorXd increment = still, residual, found;
  increment.segment<3>(3 * 26) << 1e-7, -2e-7, 1e-7;
  const auto error = [&] {
    REQUIRE(problem.evaluate(increment, residual));
    tangent->apply(-residual, found);
    return (found - increment).norm() / increment.norm();
  };
  CHECK(error() < 1e-5);
  contact.springs = {spring_between(8, 26, 1.05 * stiffness)};
  CHECK(tangent->renew(still, true) == 1);
  CHECK(error() > 1e-3);
  CHECK(tangent->catch_up());
  CHECK_FALSE(tangent->catch_up());
  CHECK(error() < 1e-5);
  contact.springs = {spring_between(8, 26, 2.0 * stiffness)};
  CHECK(tangent->renew(still, true) == 1);
  CHECK(error() < 1e-5);
  CHECK_FALSE(tangent->catch_up());
  contact.springs.clear();
  CHECK(tangent->renew(still) == n_all);
  CHECK(error() < 1e-5);
}
