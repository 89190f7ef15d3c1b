// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/step_start.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Two nodes that turn, and a block that remembers three lanes.
State some_state() {
  State state;
  state.time = 2.0;
  state.coordinates = Eigen::Matrix3Xd::Constant(3, 2, 1.0);
  state.velocity = Eigen::Matrix3Xd::Constant(3, 2, 0.5);
  state.rotations.angle = Eigen::Matrix3Xd::Constant(3, 2, 0.1);
  state.forces.internal = Eigen::Matrix3Xd::Constant(3, 2, 7.0);
  state.blocks.resize(1);
  state.blocks[0].values.assign(3, Lanes::Constant(4.0));
  state.blocks[0].hourglass_work = 6.0;
  return state;
}

void change(State& state) {
  state.time = 3.0;
  state.coordinates.setZero();
  state.velocity.setZero();
  state.rotations.angle.setZero();
  state.forces.internal.setZero();
  state.blocks[0].values.assign(3, Lanes::Zero());
  state.blocks[0].hourglass_work = 0.0;
}

}  // namespace

TEST_CASE("what a step begins at comes back, whole or of elements alone", "[core][statics]") {
  State state = some_state();
  StepStart start;
  start.remember(state);
  change(state);
  start.restore_elements(state);
  CHECK((state.blocks[0].values[2] == 4.0).all());
  CHECK(state.blocks[0].hourglass_work == 6.0);
  CHECK(state.time == 3.0);
  CHECK(state.coordinates.isZero(0.0));
  start.restore(state);
  CHECK(state.time == 2.0);
  CHECK(state.coordinates == some_state().coordinates);
  CHECK(state.velocity == some_state().velocity);
  CHECK(state.rotations.angle == some_state().rotations.angle);
  CHECK(state.forces.internal == some_state().forces.internal);
}

TEST_CASE("a step that begins later begins at the state of then", "[core][statics]") {
  State state = some_state();
  StepStart start;
  start.remember(state);
  change(state);
  start.remember(state);
  CHECK(start.time() == 3.0);
  CHECK(start.coordinates().isZero(0.0));
  CHECK(start.forces().internal.isZero(0.0));
}
