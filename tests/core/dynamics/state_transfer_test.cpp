// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/state_transfer.hpp"

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_shell.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two sheets side by side, blocks 0 and 1, of three shells each that share nodes at x = 3.
struct Sheets {
  Mesh mesh =
      MeshBuilder()
          .add_shells({.id = 1, .name = "a", .cells = {3, 1}, .u = {3, 0, 0}, .v = {0, 1, 0}})
          .add_shells(
              {.id = 2, .name = "b", .cells = {3, 1}, .origin = {3, 0, 0}, .u = {3, 0, 0}, .v = {0, 1, 0}})
          .build();

  Model make(double drilling) const {
    Model model;
    model.mesh = &mesh;
    ShellSettings settings = gauss_layers();
    settings.drilling = drilling;
    const std::vector<double> thickness(3, 0.1);
    for (std::uint32_t block = 0; block < 2; ++block)
      model.blocks.push_back(make_shell_block(mesh, block, shell4_bt_shell,
                                              {ElasticLaw{{160e9, 80e9}}, 7800.0}, settings, thickness));
    return model;
  }
};

/// A state whose numbers tell where they stand: values of batches 1, 2, 3, ...; nodes moved and in motion.
State make_numbered(const Model& model) {
  State state = make_state(model.mesh->coordinates(), model.blocks, 0.0);
  for (ModelBlockState& block : state.blocks) {
    for (std::size_t i = 0; i < block.values.size(); ++i)
      block.values[i].setConstant(1.0 + static_cast<double>(i));
    block.hourglass_work = 7.0;
  }
  state.coordinates.array() += 0.5;
  state.velocity.setConstant(2.0);
  state.rotations.angle.setConstant(0.1);
  state.energies.internal = 5.0;
  state.energies.external = 8.0;
  state.energies.kinetic = 3.0;
  return state;
}

}  // namespace

TEST_CASE("drilling that did not count before begins without moments", "[core][transfer]") {
  const Sheets sheets;
  const Model earlier = sheets.make(0.0), model = sheets.make(1e-3);
  const State from = make_numbered(earlier);
  State state = make_state(sheets.mesh.coordinates(), model.blocks, 0.0);
  take_over({{0, 1}}, earlier, from, model, state);
  const std::size_t n = earlier.blocks[0].layout.size();
  REQUIRE(model.blocks[0].layout.size() == n + 4);
  const auto value = [&](std::size_t i) { return state.blocks[0].values[i](0); };
  CHECK(value(n - 3) == static_cast<double>(n - 2));
  for (std::size_t i = n - 2; i < n + 2; ++i) CHECK(value(i) == 0.0);
  CHECK(value(n + 2) == static_cast<double>(n - 1));  // growth of the thickness
  CHECK(value(n + 3) == static_cast<double>(n));      // work of the stress
}

TEST_CASE("shells go on to resist drilling as before", "[core][transfer]") {
  const Sheets sheets;
  const Model earlier = sheets.make(1e-3);
  Model model = sheets.make(0.0);
  keep_drilling({{0, std::nullopt}}, earlier, model);
  CHECK(model.blocks[0].shell.drilling == 1e-3);
  CHECK(model.blocks[0].layout.size() == earlier.blocks[0].layout.size());
  CHECK(model.blocks[1].shell.drilling == 0.0);
}

TEST_CASE("of the blocks that are taken over nodes and elements are", "[core][transfer]") {
  const Sheets sheets;
  const Model model = sheets.make(0.0);
  const State from = make_numbered(model);
  State state = make_state(sheets.mesh.coordinates(), model.blocks, 1.0);
  take_over({{std::nullopt, 1}, false}, model, from, model, state);
  CHECK(state.blocks[0].values[0](0) == 0.0);
  CHECK(state.blocks[1].values[0](0) == 1.0);
  CHECK(state.blocks[1].hourglass_work == 7.0);
  for (Eigen::Index i = 0; i < state.coordinates.cols(); ++i) {
    const double x = sheets.mesh.coordinates()(0, i), moved = x >= 3.0 ? 0.5 : 0.0;
    CHECK(state.coordinates(0, i) == x + moved);
    CHECK(state.rotations.angle(0, i) == (x >= 3.0 ? 0.1 : 0.0));
  }
  CHECK(state.velocity.isZero(0.0));  // of load steps
  CHECK(state.energies.internal == 0.0);
  CHECK(state.time == 1.0);
}

TEST_CASE("energies go on where all blocks do, and their error begins anew", "[core][transfer]") {
  const Sheets sheets;
  const Model model = sheets.make(0.0);
  const State from = make_numbered(model);
  State state = make_state(sheets.mesh.coordinates(), model.blocks, 0.0);
  take_over({{0, 1}}, model, from, model, state);
  CHECK(state.velocity == from.velocity);
  CHECK(state.energies.internal == 5.0);
  CHECK(state.energies.external == 8.0);
  CHECK(state.energies.kinetic == 0.0);
  CHECK(state.energies.start == -3.0);
}

TEST_CASE("rigid bodies go on from where they are, about the centre of mass of now",
          "[core][transfer][rigid]") {
  const Sheets sheets;
  Model earlier = sheets.make(0.0), model = sheets.make(0.0);
  RigidBody body;
  body.mass = 1.0;
  for (std::uint32_t i = 0; i < sheets.mesh.n_nodes(); ++i) body.nodes.push_back(NodeIndex{i});
  body.arms = sheets.mesh.coordinates();
  model.mass = Eigen::RowVectorXd::Ones(body.arms.cols());
  earlier.rigid.bodies = {body};
  body.centre = {0.0, 0.0, 2.0};
  model.rigid.bodies = {body};
  State from = make_numbered(earlier);
  RigidBodyState moved;
  moved.position = {1.0, 2.0, 3.0};
  moved.orientation = turn_by({0.5 * EIGEN_PI, 0.0, 0.0});
  moved.angle = {0.5 * EIGEN_PI, 0.0, 0.0};
  from.rigid = {moved};
  State state = make_state(sheets.mesh.coordinates(), model.blocks, 0.0);
  take_over({{0, 1}, true, {0}}, earlier, from, model, state);
  REQUIRE(state.rigid.size() == 1);
  CHECK(state.rigid[0].position.isApprox(Eigen::Vector3d(1.0, 0.0, 3.0)));
  CHECK(state.rigid[0].orientation.isApprox(moved.orientation));
  CHECK(state.rigid[0].angle == moved.angle);
  take_over({{0, 1}, true, {std::nullopt}}, earlier, from, model, state);
  CHECK(state.rigid[0].position == body.centre);
}
