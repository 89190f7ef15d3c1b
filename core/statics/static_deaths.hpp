// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/state.hpp"

namespace contactsim {

/// What has elements die in a load step that has found equilibrium, so that it is sought anew: CONTROL
/// FAILURE.
class StaticDeaths {
 public:
  virtual ~StaticDeaths() = default;

  /// Looks at an equilibrium that is not taken yet. Returns whether elements die, or go on to fade:
  /// ModelBlockState::life says from now on what they give.
  ///   repeats  another state of the same step was looked at before
  virtual bool look(State& state, bool repeats) = 0;
  /// Keeps what follow() is about to change, once a step.
  ///   state  of the step's start, with the lives of then
  virtual void keep(const State& state) = 0;
  /// Takes the dead out of loads and contact, whose state is that of the step's start.
  virtual void follow(const State& state) = 0;
  /// Ends a step that found no equilibrium: loads and contact are as keep() has kept them.
  ///   state  as for keep()
  virtual void restore(State& state) = 0;
};

}  // namespace contactsim
