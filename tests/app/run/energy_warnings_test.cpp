// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/energy_warnings.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// A run of one steel cube, block 7, with a largest term of 1000.
struct WarnedCube {
  Mesh mesh = MeshBuilder().add_hexes({.id = 7, .name = "cube"}).build();
  Model model;
  State state;
  Diagnostics found;
  EnergyWarnings warnings{model, found};

  WarnedCube() {
    model.mesh = &mesh;
    model.blocks.push_back(
        make_solid_block(mesh, 0, *find_solid_element(Shape::hex8, "mean_quadrature"), undamped_elastic()));
    model.mass = Eigen::RowVectorXd::Ones(mesh.n_nodes());
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    state.dt = 1e-3;
    state.energies.largest = 1000.0;
    warnings.begin(state);
  }
  /// Steps up to a number, whose errors are a constant.
  void step_to(std::int64_t last, double error) {
    state.energies.error = error;
    while (state.step < last) {
      ++state.step;
      state.time = 0.5 * static_cast<double>(state.step);
      warnings.step(state);
    }
  }
  double& stress_work() { return state.blocks[0].values[model.blocks[0].layout.energy()](0); }
};

}  // namespace

TEST_CASE("an energy balance that is off is reported once, with step and share", "[app][energy]") {
  WarnedCube cube;
  cube.step_to(400, 1.0);
  CHECK(messages(cube.found) == "");
  cube.step_to(900, -20.0);
  const std::string said = messages(cube.found);
  CHECK_THAT(
      said, Contains("the energy balance is off by -20 (-2 % of the largest term); a smaller TIME STEP SCALE "
                     "FACTOR tells whether the steps are too large [energy-error]\n"));
  CHECK(cube.found.all().size() == 1);
}

TEST_CASE("a block that has given out energy is reported at the next look, or at the end", "[app][energy]") {
  WarnedCube cube;
  cube.step_to(100, 0.0);
  cube.stress_work() = -50.0;
  cube.step_to(199, 0.0);
  CHECK(messages(cube.found) == "");
  cube.step_to(200, 0.0);
  CHECK(messages(cube.found) ==
        "warning: at step 200, time 100, the stresses of cube (block 7) have given out 50 more energy than "
        "they have "
        "taken up (5 % of the largest term); the energy balance does not show it; a smaller TIME STEP SCALE "
        "FACTOR "
        "or finer elements help [negative-internal-energy]\n");
  cube.warnings.end(cube.state);
  CHECK(cube.found.all().size() == 1);

  WarnedCube other;
  other.step_to(150, 0.0);
  other.state.blocks[0].hourglass_work = -20.0;
  other.warnings.end(other.state);
  CHECK_THAT(messages(other.found),
             Contains("at step 150, time 75, the hourglass resistance of cube (block 7) has "
                      "given out 20 more energy than it has taken up (2 % of"));
}
