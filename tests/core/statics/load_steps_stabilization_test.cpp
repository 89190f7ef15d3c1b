// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/load_steps.hpp"
#include "support/catch.hpp"
#include "support/static_cube.hpp"
#include "support/trial_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Pulls the nodes of the top along z, harder as time goes by.
class PulledTop final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Matrix3Xd::Zero(3, motion.coordinates.cols());
    forces.row(2).tail(9).setConstant(1e8 * motion.time);
    return {};
  }
};

/// A cube on held nodes in two time stepping blocks of steps of 1/4 and 1/2; stabilization holds its top.
struct StabilizedCube {
  explicit StabilizedCube(bool is_stabilized)
      : cube({{0}, {1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}}), contact(cube.mesh.coordinates()) {
    if (is_stabilized) contact.stabilized = {18, 19, 20, 21, 22, 23, 24, 25, 26};
    contact.ground = 1e11;
    LoadPeriod first, second;
    first.end = second.start = 1.0;
    second.end = 2.0;
    first.increment = 0.25;
    second.increment = 0.5;
    SolverSettings settings;
    settings.cg.full_tangent.emplace();
    settings.cg.target_relative_residual = 1e-8;
    steps.emplace(cube.model, ForceTerms{*cube.internal, load, &contact}, &contact, settings,
                  LoadSchedule({first, second}, {}), cube.state);
    steps->start();
  }
  /// The ramps that a step asks for.
  std::vector<double> ramps_of_step() {
    contact.levels.clear();
    REQUIRE(steps->advance());
    std::vector<double> ramps;
    for (const StabilizationLevel& level : contact.levels) {
      CHECK(level.n_steps == contact.levels.front().n_steps);
      ramps.push_back(level.ramp);
    }
    return ramps;
  }
  double lift() const { return (cube.state.coordinates - cube.mesh.coordinates()).row(2).tail(9).mean(); }

  StaticCube cube;
  TrialContact contact;
  PulledTop load;
  std::optional<LoadSteps> steps;
};

using Ramps = std::vector<double>;

}  // namespace

TEST_CASE("stabilization falls with the steps of a time stepping block", "[core][statics]") {
  StabilizedCube cube(true);
  CHECK(cube.ramps_of_step() == Ramps{0.75});
  CHECK(cube.contact.levels.front().n_steps == 4.0);
  CHECK_FALSE(cube.steps->report().ends_block);
  REQUIRE(cube.steps->report().stabilizing_force);
  CHECK(*cube.steps->report().stabilizing_force > 1e-3);
  CHECK(cube.ramps_of_step() == Ramps{0.5});
  CHECK(cube.ramps_of_step() == Ramps{0.25});
}

TEST_CASE("the last step of a block ends without stabilization, which leaves nothing behind",
          "[core][statics]") {
  StabilizedCube cube(true), plain(false);
  cube.ramps_of_step();
  CHECK(plain.ramps_of_step().empty());
  CHECK_FALSE(plain.steps->report().stabilizing_force);
  CHECK(cube.lift() < 0.9 * plain.lift());  // what holds the top is felt
  for (int i = 0; i < 2; ++i) cube.ramps_of_step(), plain.ramps_of_step();
  const Ramps last = cube.ramps_of_step();
  plain.ramps_of_step();
  REQUIRE(last.size() >= 3);
  CHECK(last.front() == 0.25);  // as the step began
  for (std::size_t i = 1; i + 1 < last.size(); ++i) CHECK(last[i] == Approx(0.1 * last[i - 1]));
  CHECK(last.back() == 0.0);
  CHECK(cube.steps->report().ends_block);
  CHECK(*cube.steps->report().stabilizing_force == 0.0);
  CHECK(cube.lift() == Approx(plain.lift()).epsilon(1e-6));
  CHECK((cube.cube.state.coordinates - plain.cube.state.coordinates).norm() < 1e-6 * plain.lift());
  // The next block has its own.
  CHECK(cube.ramps_of_step() == Ramps{0.5});
  CHECK(cube.contact.levels.front().n_steps == 2.0);
}
