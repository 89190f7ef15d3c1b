// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/block_energy_watch.hpp"

#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two blocks of one cube each, of the modulus and the density of steel, in a run with a largest term of
/// 1000.
struct CubeBlocks {
  Mesh mesh = MeshBuilder().add_hexes({.id = 7}).add_hexes({.id = 9, .origin = {5, 0, 0}}).build();
  Model model;
  State state;
  BlockEnergyWatch watch{model};

  CubeBlocks() {
    model.mesh = &mesh;
    for (std::uint32_t i = 0; i < 2; ++i)
      model.blocks.push_back(
          make_solid_block(mesh, i, *find_solid_element(Shape::hex8, "mean_quadrature"), undamped_elastic()));
    model.mass = Eigen::RowVectorXd::Ones(mesh.n_nodes());
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    state.dt = 1e-3;
    state.energies.largest = 1000.0;
  }

  double& stress_work(std::size_t block) {
    return state.blocks[block].values[model.blocks[block].layout.energy()](0);
  }
};

}  // namespace

TEST_CASE("a block that gives out energy is named, once", "[app][energy]") {
  CubeBlocks cubes;
  cubes.watch.begin(cubes.state);
  cubes.stress_work(0) = 500.0;
  cubes.stress_work(1) = -9.0;  // less than a hundredth of the largest term
  CHECK(cubes.watch.look(cubes.state).empty());
  cubes.stress_work(1) = -11.0;
  const auto found = cubes.watch.look(cubes.state);
  REQUIRE(found.size() == 1);
  CHECK(found[0].mesh_block == 1);
  CHECK(found[0].energy == -11.0);
  CHECK(!found[0].is_of_hourglasses);
  CHECK(cubes.watch.look(cubes.state).empty());
}

TEST_CASE("so is one whose hourglasses give out energy, whatever its stresses took", "[app][energy]") {
  CubeBlocks cubes;
  cubes.watch.begin(cubes.state);
  cubes.stress_work(0) = 500.0;
  cubes.state.blocks[0].hourglass_work = -11.0;
  const auto found = cubes.watch.look(cubes.state);
  REQUIRE(found.size() == 1);
  CHECK(found[0].mesh_block == 0);
  CHECK(found[0].is_of_hourglasses);
}

TEST_CASE("stresses at the start may give out what they hold", "[app][energy]") {
  CubeBlocks cubes;
  for (std::size_t i = 0; i < 3; ++i) cubes.state.blocks[1].values[i].setConstant(10e6);
  cubes.watch.begin(cubes.state);
  const double held = 0.5 * 10e6 * 10e6 / 160e9;  // pressure^2 / 2 bulk, volume 1
  cubes.stress_work(1) = -held;
  CHECK(cubes.watch.look(cubes.state).empty());
  cubes.stress_work(1) = -2.0 * held - 9.0;
  CHECK(cubes.watch.look(cubes.state).empty());
  cubes.stress_work(1) = -2.0 * held - 11.0;
  CHECK(cubes.watch.look(cubes.state).size() == 1);
}

TEST_CASE("a share of next to nothing is nobody's energy", "[app][energy]") {
  CubeBlocks cubes;
  cubes.watch.begin(cubes.state);
  cubes.state.energies.largest = 1e-65;
  cubes.stress_work(0) = -1e-65;
  CHECK(cubes.watch.look(cubes.state).empty());
}
