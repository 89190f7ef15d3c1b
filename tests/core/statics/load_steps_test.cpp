// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/load_steps.hpp"

#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Pulls all nodes along z, harder as time goes by.
class GrowingLoad final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Matrix3Xd::Zero(3, motion.coordinates.cols());
    forces.row(2).setConstant(1e9 * motion.time);
    return {};
  }
};

/// A cube that stands on its bottom, under a load in four steps.
struct LoadedCube {
  explicit LoadedCube(bool has_tangent) : cube({{0}, {1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}}) {
    LoadPeriod period;
    period.end = 1.0;
    period.increment = 0.25;
    SolverSettings settings;
    if (has_tangent) settings.cg.full_tangent.emplace();
    steps.emplace(cube.model, ForceTerms{*cube.internal, load}, nullptr, settings, LoadSchedule({period}, {}),
                  cube.state);
    steps->start();
  }

  StaticCube cube;
  GrowingLoad load;
  std::optional<LoadSteps> steps;
};

}  // namespace

TEST_CASE("a load step that is given up leaves the state before it, and what follows has the same bits",
          "[core][statics]") {
  const bool has_tangent = GENERATE(false, true);
  const int n_evaluations = GENERATE(1, 2, 4);
  LoadedCube straight(has_tangent), stopped(has_tangent);
  for (LoadedCube* one : {&straight, &stopped}) REQUIRE(one->steps->advance());
  const Eigen::Matrix3Xd before = stopped.cube.state.coordinates;
  int n_left = n_evaluations;
  stopped.steps->give_up_when([&] { return --n_left < 0; });
  CHECK_FALSE(stopped.steps->advance());
  CHECK(stopped.cube.state.coordinates == before);
  CHECK(stopped.cube.state.time == 0.25);
  CHECK(stopped.cube.state.step == 1);
  stopped.steps->give_up_when(nullptr);
  for (LoadedCube* one : {&straight, &stopped}) REQUIRE(one->steps->advance());
  CHECK(stopped.cube.state.coordinates == straight.cube.state.coordinates);
  CHECK((straight.cube.state.coordinates - before).norm() > 0.0);
}
