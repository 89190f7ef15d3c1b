// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/state.hpp"

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;

namespace {

SavedState saved_of(State& state) {
  StateArchive saves;
  archive(state, saves);
  return saves.take();
}

/// Whether two states hold the same numbers where they are saved.
bool are_alike(State& a, State& b) {
  const SavedState of_a = saved_of(a), of_b = saved_of(b);
  if (of_a.arrays().size() != of_b.arrays().size()) return false;
  for (const SavedArray& array : of_a.arrays()) {
    const SavedArray* other = of_b.find(array.name);
    if (other == nullptr || !std::ranges::equal(other->bytes, array.bytes)) return false;
  }
  return true;
}

/// Gives every number that a state without rotations remembers a value of its own.
void fill(State& state) {
  state.step = 7;
  state.time = 0.5;
  state.dt = 0.25;
  state.next_dt = 0.125;
  state.first_dt = 0.0625;
  state.stable_step = {1.0, 2.0, 3, 4.0};
  double next = 10.0;
  for (Matrix3Xd* array : {&state.coordinates, &state.velocity, &state.acceleration, &state.forces.internal,
                           &state.forces.external})
    array->setConstant(next++);
  Energies& energies = state.energies;
  for (double* energy :
       {&energies.kinetic, &energies.internal, &energies.hourglass, &energies.bulk_viscosity,
        &energies.external, &energies.contact, &energies.friction, &energies.contact_damping,
        &energies.impact, &energies.stabilization, &energies.error, &energies.unseen, &energies.start,
        &energies.largest, &state.begun.internal, &state.begun.external, &state.begun.contact})
    *energy = next++;
  state.momentum = {1, 2, 3};
  for (ModelBlockState& block : state.blocks) {
    for (Lanes& lanes : block.values) lanes.setConstant(next++);
    block.hourglass_work = next++;
  }
  RigidBodyState body;
  body.position = {4, 5, 6};
  body.after.spin = {7, 8, 9};
  state.rigid = {body, body};
  state.death.dying = {{{3}, 5, 2}};
  state.death.checked = {0.25, 0.5};
}

}  // namespace

TEST_CASE("a state at rest stands on the mesh with no forces and knows no step yet", "[core][state]") {
  const SampleRun run;
  const State state = make_state(2.0 * run.mesh.coordinates(), run.model.blocks, 3.0);
  const auto n = static_cast<Eigen::Index>(run.mesh.n_nodes());
  CHECK(state.time == 3.0);
  CHECK(state.step == 0);
  CHECK(state.dt == 0.0);
  CHECK(state.coordinates == 2.0 * run.mesh.coordinates());
  for (const Matrix3Xd* array :
       {&state.velocity, &state.acceleration, &state.forces.internal, &state.forces.external})
    CHECK(*array == Matrix3Xd::Zero(3, n));
  CHECK(state.forces.contact.cols() == 0);
  CHECK_FALSE(state.rotations.exist());
  CHECK(state.blocks.size() == run.model.blocks.size());
  CHECK(state.rigid.empty());
}

TEST_CASE(
    "a state begins with velocities that it is given, and external forces take room where there are loads",
    "[core][state]") {
  const SampleRun run;
  const auto n = static_cast<Eigen::Index>(run.mesh.n_nodes());
  const Matrix3Xd velocity = Matrix3Xd::Constant(3, n, 5.0);
  State state = make_state(run.mesh.coordinates(), run.model.blocks, 0.0, velocity, false);
  CHECK(state.velocity == velocity);
  CHECK(state.forces.external.cols() == 0);
  state.forces.internal.col(1) = Eigen::Vector3d(1, 2, 3);
  CHECK(state.forces.at(1) == Eigen::Vector3d(1, 2, 3));
  state.forces.external = velocity;
  state.forces.contact = 10.0 * velocity;
  CHECK(state.forces.at(1) == Eigen::Vector3d(56, 57, 58));
}

TEST_CASE("a state is restored into one with loads where it had none, and the other way round",
          "[core][state]") {
  SampleRun run;
  State without = make_state(run.mesh.coordinates(), run.model.blocks, 0.0, Matrix3Xd(3, 0), false);
  State with = make_state(run.mesh.coordinates(), run.model.blocks, 0.0);
  with.forces.external.setConstant(4.0);
  with.forces.internal.setConstant(3.0);
  without.forces.internal.setConstant(2.0);
  const SavedState saved_with = saved_of(with), saved_without = saved_of(without);
  State begun = make_state(run.mesh.coordinates(), run.model.blocks, 0.0);
  StateArchive from_without(saved_without);
  archive(begun, from_without);
  CHECK(begun.forces.internal == without.forces.internal);
  CHECK(begun.forces.external == Matrix3Xd::Zero(3, begun.forces.internal.cols()));
  StateArchive from_with(saved_with);
  archive(without, from_with);
  CHECK(without.forces.internal == with.forces.internal);
  CHECK(without.forces.external.cols() == 0);
}

TEST_CASE("nodes have rotations where some block has nodes that turn", "[core][state]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .origin = {0, 0, 5}});
  const Mesh mesh = b.build();
  ElementProperties properties;
  properties.law = ElasticLaw{{1.0, 0.5}};
  properties.density = 1.0;
  const std::vector<double> thickness{0.1};
  std::vector<ModelBlock> blocks;
  blocks.push_back(make_solid_block(mesh, 0, *default_solid_element(Shape::hex8), properties));
  CHECK_FALSE(make_state(mesh.coordinates(), blocks, 0.0).rotations.exist());
  blocks.push_back(
      make_shell_block(mesh, 1, *find_shell_element(Shape::shell4, "bt_shell"), properties, {}, thickness));
  const State state = make_state(mesh.coordinates(), blocks, 0.0);
  REQUIRE(state.rotations.exist());
  for (const Matrix3Xd* array : {&state.rotations.angle, &state.rotations.velocity,
                                 &state.rotations.acceleration, &state.rotations.moments.internal})
    CHECK(*array == Matrix3Xd::Zero(3, 12));
  CHECK(state.rotations.moments.contact.cols() == 0);
}

TEST_CASE("every number of a state that is saved is restored", "[core][state]") {
  SampleRun run;
  State at_rest = run.state;
  fill(run.state);
  CHECK_FALSE(are_alike(run.state, at_rest));
  const SavedState saved = saved_of(run.state);
  State restored = at_rest;
  StateArchive restores(saved);
  archive(restored, restores);
  CHECK(are_alike(restored, run.state));
  CHECK(restored.step == 7);
  CHECK(restored.first_dt == 0.0625);
  CHECK(restored.stable_step.count == 3);
  CHECK(restored.coordinates == run.state.coordinates);
  CHECK(restored.forces.external == run.state.forces.external);
  CHECK(restored.energies.stabilization == run.state.energies.stabilization);
  CHECK(restored.energies.largest == run.state.energies.largest);
  CHECK(restored.begun.contact == run.state.begun.contact);
  CHECK(restored.momentum == Eigen::Vector3d(1, 2, 3));
  REQUIRE(restored.rigid.size() == 2);
  CHECK(restored.rigid[1].position == Eigen::Vector3d(4, 5, 6));
  CHECK(restored.rigid[1].after.spin == Eigen::Vector3d(7, 8, 9));
  REQUIRE(restored.death.dying.size() == 1);
  CHECK(restored.death.dying[0].element == ElementIndex{3});
  CHECK(restored.death.dying[0].n_left == 2);
  CHECK(restored.death.checked == std::vector{0.25, 0.5});
  for (std::size_t i = 0; i < restored.blocks.size(); ++i)
    CHECK(restored.blocks[i].hourglass_work == run.state.blocks[i].hourglass_work);
}

TEST_CASE("energy of stabilization is saved where there is any, and kept where none was saved",
          "[core][state]") {
  SampleRun run;
  const std::size_t n_without = saved_of(run.state).arrays().size();
  const SavedState without = saved_of(run.state);
  run.state.energies.stabilization = 2.0;
  CHECK(saved_of(run.state).arrays().size() == n_without + 1);
  State other = run.state;
  StateArchive restores(without);
  archive(other, restores);
  CHECK(other.energies.stabilization == 2.0);
}

TEST_CASE("a state of another mesh is not restored", "[core][state]") {
  SampleRun run;
  const SavedState saved = saved_of(run.state);
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).build();
  State other = make_state(mesh.coordinates(), {}, 0.0);
  StateArchive restores(saved);
  CHECK_THROWS_AS(archive(other, restores), FileError);
}
