// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// Tells when energy that appears or vanishes is worth a warning. A run that begins at rest, or that a load
/// sets moving, has next to no energy for some steps, of which the error of its first, growing steps is a
/// share: nothing is said while the largest term grows fast, nor while it is no more than round-off makes.
class EnergyWatch {
 public:
  ///   model  must outlive the watch
  explicit EnergyWatch(const Model& model) : model_(model) {}

  /// Looks at the state after a step; whether its error is a worrying share of the largest term. To be called
  /// after every step until it says so.
  bool is_off(const State& state);

 private:
  const Model& model_;
  double largest_ = 0.0;  ///< term at the step before [energy]
  int n_unsettled_ = 0;   ///< steps on end in which it has grown fast
};

/// Energy that the round-off of the coordinates makes: they are known to a share of the mesh's extent, and
/// seem to move by that in a step [energy].
double energy_of_round_off(const Model& model, double dt);

}  // namespace contactsim
