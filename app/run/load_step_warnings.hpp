// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "core/base/diagnostics.hpp"
#include "core/dynamics/state.hpp"
#include "core/statics/load_steps.hpp"

namespace contactsim {

/// Warns of load steps that were put up with, above a target and below what is acceptable, once a run each:
/// "equilibrium-acceptable" of forces left over, "multipliers-unfinished" of updates of multipliers,
/// "stabilization-remains" and "stabilization-energy" of contact that is stabilized.
class LoadStepWarnings {
 public:
  explicit LoadStepWarnings(Diagnostics& warnings) : warnings_(warnings) {}

  /// To be called before the first step: "linear-solver" where the equation solver is not the one asked for,
  /// "control-failure" where nothing can die.
  void begin(const LoadSteps& load_steps, const SolverSettings& settings, bool has_deaths);
  /// To be called when CONTROL FAILURE has ended at its largest number of iterations with deaths that nothing
  /// has balanced: "deaths-left".
  void note_deaths_left(const State& state);
  /// To be called after every step.
  void step(const State& state, const LoadStepReport& report);
  /// To be called at the end of a run.
  void end(const State& state) const;

 private:
  /// The steps above a target, and the worst of them.
  struct Steps {
    std::int64_t n = 0, first = 0, worst = 0;
    double first_time = 0.0, worst_time = 0.0;  ///< [time]
    double share = 0.0, target = 0.0;           ///< of the worst, over their reference [1]
    void add(const State& state, double share_now, double target_now);
    std::string format(const char* what, const char* reference) const;
  };

  void warn_of_stabilization(const Energies& energies) const;

  Diagnostics& warnings_;
  Steps searches_, updates_, stabilized_;
  std::int64_t n_with_deaths_ = 0, first_with_deaths_ = 0;  // steps with deaths that nothing has balanced
};

}  // namespace contactsim
