// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/run/block_energy_watch.hpp"
#include "app/run/energy_watch.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// Warns of energy that appears or vanishes: "energy-error" once a run, "negative-internal-energy" once a
/// block.
class EnergyWarnings {
 public:
  /// All must outlive this.
  ///   share  null on one rank
  EnergyWarnings(const Model& model, Diagnostics& warnings, const RankShare* share = nullptr)
      : model_(model), warnings_(warnings), block_watch_(model, share) {}

  /// To be called once, before the first step or where a run goes on.
  void begin(const State& state) { block_watch_.begin(state); }
  /// To be called after every step.
  void step(const State& state);
  /// To be called at the end of a run.
  void end(const State& state);

 private:
  const Model& model_;
  Diagnostics& warnings_;
  EnergyWatch watch_{model_};
  BlockEnergyWatch block_watch_;
  bool has_warned_ = false;
};

}  // namespace contactsim
