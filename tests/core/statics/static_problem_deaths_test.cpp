// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_problem.hpp"
#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A stretched cube of eight elements, of which the first, at node 0, is about to die.
struct DyingCube {
  DyingCube() {
    Eigen::VectorXd residual;
    const Eigen::VectorXd increment = cube.pulled(1e-3);
    REQUIRE(cube.problem->evaluate(increment, residual));
    cube.problem->accept(increment);
    ++cube.state.step;
  }
  void kill() {
    std::vector<Lanes>& life = cube.state.blocks[0].life;
    life.assign(1, Lanes::Ones());
    life[0](0) = 0.0;
    cube.problem->note_deaths({{0}});
  }
  std::vector<std::uint32_t> held() const {
    std::vector<std::uint32_t> nodes;
    cube.problem->held().visit([&](std::uint32_t node, Eigen::Index first, const Eigen::Matrix3d& along) {
      CHECK(first == 0);
      if (along == Eigen::Matrix3d::Identity()) nodes.push_back(node);
    });
    return nodes;
  }

  StaticCube cube;
};

using HeldNodes = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("forces are those of the living, and lifeless nodes are held", "[core][statics]") {
  DyingCube dying;
  const Eigen::Matrix3Xd before = dying.cube.state.forces.internal;
  const std::vector<Lanes> values = dying.cube.state.blocks[0].values;
  CHECK(dying.held().empty());
  CHECK_FALSE(dying.cube.problem->has_deaths());
  dying.kill();
  CHECK(dying.cube.problem->has_deaths());
  CHECK(dying.held() == HeldNodes{0});
  // Nodes 0 1 3 4 9 10 12 13 are of the element; the stress is the same everywhere.
  const Eigen::Matrix3Xd& after = dying.cube.state.forces.internal;
  CHECK(after.col(0).isZero(0.0));
  for (const Eigen::Index node : {1, 3, 4, 9, 10, 12})
    CHECK((after.col(node) - before.col(node)).norm() > 1e6);
  for (const Eigen::Index node : {2, 26, 17}) CHECK(after.col(node) == before.col(node));
  // The one in the middle was in balance; its element pushed it as it pushed its own corner, the other way.
  CHECK((after.col(13) - before.col(0)).norm() < 1e-8 * before.col(0).norm());
  for (std::size_t i = 0; i < values.size(); ++i)
    CHECK((dying.cube.state.blocks[0].values[i] == values[i]).all());
}

TEST_CASE("a lifeless node stays where it is, what deaths have left is let go in the step",
          "[core][statics]") {
  DyingCube dying;
  dying.kill();
  dying.cube.problem->begin_step(1.0);
  CHECK(dying.held() == HeldNodes{0});
  Eigen::VectorXd residual;
  REQUIRE(dying.cube.problem->evaluate(Eigen::VectorXd::Zero(81), residual));
  CHECK(residual.segment<3>(0).isZero(0.0));
  CHECK((residual - dying.cube.state.forces.internal.reshaped()).norm() == 0.0);
  Eigen::VectorXd pushed = Eigen::VectorXd::Ones(81);
  dying.cube.problem->project(pushed);
  CHECK(pushed.head<3>().isZero(0.0));
  CHECK(pushed.tail<78>() == Eigen::VectorXd::Ones(78));
  dying.cube.problem->accept(Eigen::VectorXd::Zero(81));
  CHECK_FALSE(dying.cube.problem->has_deaths());
}

TEST_CASE("the step after deaths does the work of half of what is let go", "[core][statics]") {
  // Everything moves on, against what is left over at the start: the mean of that and of the end does work on
  // elements; what was let go, half of it on average, has borne the rest.
  DyingCube dying;
  dying.kill();
  dying.cube.problem->begin_step(1.0);
  const Eigen::VectorXd start = dying.cube.state.forces.internal.reshaped();
  Eigen::VectorXd increment = 1e-6 * start / start.norm(), residual;
  dying.cube.problem->project(increment);
  const double external = dying.cube.state.energies.external, internal = dying.cube.state.energies.internal;
  REQUIRE(dying.cube.problem->evaluate(increment, residual));
  const Eigen::VectorXd end = dying.cube.state.forces.internal.reshaped();
  dying.cube.problem->accept(increment);
  CHECK(dying.cube.state.energies.internal - internal == Approx(-0.5 * (start + end).dot(increment)));
  CHECK(dying.cube.state.energies.external - external ==
        Approx((0.5 * (start + end) - 0.5 * start).dot(increment) - 0.5 * (start + end).dot(increment)));
}

TEST_CASE("deaths that are undone leave no held node", "[core][statics]") {
  DyingCube dying;
  dying.kill();
  dying.cube.problem->undo_deaths({}, false);
  CHECK_FALSE(dying.cube.problem->has_deaths());
  dying.cube.problem->begin_step(1.0);
  CHECK(dying.held().empty());
  dying.cube.problem->hold_lifeless({{3}, {8}});
  dying.cube.problem->begin_step(1.0);
  CHECK(dying.held() == HeldNodes{3, 8});
}

TEST_CASE("a lifeless node that conditions hold in part is held wholly, once", "[core][statics]") {
  StaticCube cube;
  PrescribedMotion hold;
  hold.direction = Components{{true, false, false}};
  hold.nodes = {{0}, {5}};
  cube.model.kinematic_constraints = KinematicConstraints(cube.mesh, {hold});
  cube.problem->hold_lifeless({{0}, {7}});
  cube.problem->begin_step(1.0);
  std::map<std::uint32_t, std::vector<double>> traces;
  cube.problem->held().visit([&](std::uint32_t node, Eigen::Index, const Eigen::Matrix3d& along) {
    traces[node].push_back(along.trace());
  });
  CHECK(traces == std::map<std::uint32_t, std::vector<double>>{{0, {3.0}}, {5, {1.0}}, {7, {3.0}}});
}
