// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/load_steps.hpp"
#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Pulls the nodes at z = 3 upwards, harder as time goes by.
class PullOnTop final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Matrix3Xd::Zero(3, motion.coordinates.cols());
    forces.row(2).tail(4).setConstant(1e8 * motion.time);
    return {};
  }
};

/// Has elements die from the top downwards, one at a look, as often as is wanted.
class DeathsFromTop final : public StaticDeaths {
 public:
  int n_to_die = 0;
  std::string calls;  ///< look, keep, follow, restore by their first letters

  bool look(State& state, bool repeats) override {
    calls += repeats ? "L" : "l";
    step_of_look = state.step;
    if (n_to_die == 0) return false;
    --n_to_die;
    std::vector<Lanes>& life = state.blocks[0].life;
    if (life.empty()) life.assign(1, Lanes::Ones());
    Eigen::Index top = 2;
    while (life[0](top) == 0.0) --top;
    life[0](top) = 0.0;
    return true;
  }
  void keep(const State& state) override {
    calls += "k";
    CHECK(state.blocks[0].life_of(2) == 1.0);
  }
  void follow(const State& state) override {
    calls += "f";
    CHECK(state.blocks[0].life_of(2) == 0.0);
  }
  void restore(State&) override { calls += "r"; }
  std::int64_t step_of_look = -1;
};

/// Three elements one on top of the other, on held nodes.
struct Tower {
  explicit Tower(std::optional<std::int64_t> most_rounds = 100)
      : mesh(MeshBuilder().add_hexes({.cells = {1, 1, 3}, .size = {1, 1, 3}}).build()) {
    model.mesh = &mesh;
    ElementProperties properties{ElasticLaw{{160e9, 80e9}}, 7800.0};
    properties.linear_bulk_viscosity = properties.quadratic_bulk_viscosity = 0.0;
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, properties));
    model.mass = lumped_mass(mesh, model.blocks);
    PrescribedMotion fixed;
    fixed.direction = Components{{true, true, true}};
    fixed.nodes = {{0}, {1}, {2}, {3}};
    model.kinematic_constraints = KinematicConstraints(mesh, {fixed});
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    internal.emplace(model, state);
    SolverSettings settings;
    if (most_rounds) settings.control_failure.emplace().max_iterations = *most_rounds;
    settings.cg.full_tangent.emplace();
    LoadPeriod period;
    period.end = 1.0;
    period.increment = 0.5;
    steps.emplace(model, ForceTerms{*internal, pull}, nullptr, settings, LoadSchedule({period}, {}), state);
    steps->follow_deaths(deaths);
    steps->start();
  }

  /// How far the nodes at a height have gone up.
  double lift(int height) const {
    const Eigen::Index first = 4 * height;
    return (state.coordinates - mesh.coordinates()).row(2).segment(first, 4).mean();
  }

  Mesh mesh;
  Model model;
  State state;
  PullOnTop pull;
  DeathsFromTop deaths;
  std::optional<InternalForce> internal;
  std::optional<LoadSteps> steps;
};

}  // namespace

TEST_CASE("a step in which elements die is made anew without them", "[core][statics]") {
  Tower tower, whole;
  REQUIRE(whole.steps->advance());
  CHECK(whole.deaths.calls == "l");
  CHECK(whole.deaths.step_of_look == 1);  // criteria count the step that is being made
  CHECK(whole.steps->report().n_again == 0);
  tower.deaths.n_to_die = 1;
  REQUIRE(tower.steps->advance());
  CHECK(tower.deaths.calls == "lkfL");
  CHECK(tower.steps->report().n_again == 1);
  CHECK_FALSE(tower.steps->report().has_deaths_left);
  CHECK(tower.state.step == 1);
  CHECK(tower.state.time == 0.5);
  // Without the element on top nothing pulls those below, and its nodes stay where the step began.
  CHECK(whole.lift(2) > 1e-4);
  CHECK(std::abs(tower.lift(2)) < 1e-3 * whole.lift(2));
  CHECK(tower.lift(3) == 0.0);
}

TEST_CASE("deaths go on until none is left, or as often as the deck lets them", "[core][statics]") {
  Tower all, some(1), none(0), unasked(std::nullopt);
  for (Tower* tower : {&all, &some, &none, &unasked}) tower->deaths.n_to_die = 2;
  for (Tower* tower : {&all, &some, &none, &unasked}) REQUIRE(tower->steps->advance());
  CHECK(all.deaths.calls == "lkfLfL");
  CHECK(all.steps->report().n_again == 2);
  CHECK(all.state.blocks[0].life_of(1) == 0.0);
  CHECK(some.deaths.calls == "lkf");
  CHECK(some.steps->report().n_again == 1);
  CHECK(some.steps->report().has_deaths_left);
  CHECK(some.state.blocks[0].life_of(1) == 1.0);
  CHECK(none.deaths.calls == "");
  CHECK_FALSE(none.steps->report().has_deaths_left);
  CHECK(unasked.deaths.calls == "");
  CHECK(unasked.lift(3) > 1e-4);
}

TEST_CASE("the dead live again where their step is given up", "[core][statics]") {
  Tower tower, straight;
  for (Tower* one : {&tower, &straight}) REQUIRE(one->steps->advance());
  const Eigen::Matrix3Xd before = tower.state.coordinates;
  tower.deaths.n_to_die = 1;
  tower.deaths.calls.clear();
  tower.steps->give_up_when([&] { return tower.deaths.n_to_die == 0; });
  CHECK_FALSE(tower.steps->advance());
  CHECK(tower.deaths.calls == "lkfr");
  CHECK(tower.state.blocks[0].life_of(2) == 1.0);
  CHECK(tower.state.coordinates == before);
  CHECK(tower.state.step == 1);
  tower.steps->give_up_when(nullptr);
  for (Tower* one : {&tower, &straight}) REQUIRE(one->steps->advance());
  CHECK((tower.state.coordinates - straight.state.coordinates).norm() < 1e-12);
}

TEST_CASE("elements that died between two steps let go of what they bore", "[core][statics]") {
  Tower tower;
  REQUIRE(tower.steps->advance());
  const double top = tower.lift(3);
  REQUIRE(top > 1e-4);
  tower.state.blocks[0].life.assign(1, Lanes::Ones());
  tower.state.blocks[0].life[0](2) = 0.0;
  tower.steps->note_deaths();
  REQUIRE(tower.steps->advance());
  CHECK(tower.lift(3) == top);  // nodes of the dead stay there
  CHECK(std::abs(tower.lift(2)) < 1e-3 * top);
  CHECK(tower.state.step == 2);
}
