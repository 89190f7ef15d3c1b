// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/solver.hpp"
#include "core/functions/function.hpp"

namespace contactsim {

class StateArchive;

/// A time stepping block of load steps.
struct LoadPeriod {
  DeckName name;
  double start = 0.0, end = 0.0;     ///< [time]
  double increment = 0.0;            ///< of a step, > 0 [time]
  std::optional<Function> function;  ///< of time, whose value is the step in place of it
};

/// The sizes of load steps: those of the deck, which end where the periods do, times a multiplier that falls
/// where no equilibrium is found and comes back afterwards. Smaller steps still end where those of the deck
/// would.
/// Source: Sierra/SM 5.22, 3.2, BEGIN ADAPTIVE TIME STEPPING.
class LoadSchedule {
 public:
  ///   adaption  absent: steps are cut back, and grow to what the deck says
  LoadSchedule(std::vector<LoadPeriod> periods, std::optional<AdaptiveTimeStepping> adaption);

  /// The size of the step that begins at a time, cut at the end of its period. Precondition: the time is
  /// before the end of the last period. Throws SolveError when a function has no positive value.
  double step_at(double time) const;
  /// Where a step of such a size ends: at the end of the period itself, when it comes that near.
  double end_of(double time, double dt) const;
  /// The start and the end of the period that a step belongs to which begins there [time].
  double start_of_period(double time) const { return period_at(time).start; }
  double end_of_period(double time) const { return period_at(time).end; }
  /// Whether the last period has ended.
  bool is_over(double time) const { return time >= periods_.back().end; }
  /// Whether a step that begins there is the first one of its period.
  bool begins_period(double time) const;

  /// The time stepping block that a step belongs to which begins there.
  const DeckName& period_name(double time) const { return period_at(time).name; }

  /// To be called after a step that has found equilibrium.
  ///   begun  when the step began [time]
  void note_success(double begun, std::int64_t n_iterations);
  /// To be called after one that has not. Returns false when steps may not get smaller any more.
  bool cut_back(double begun);

  double multiplier() const { return multiplier_; }
  void archive(StateArchive& saved);

 private:
  const LoadPeriod& period_at(double time) const;
  AdaptiveTimeStepping adaption_at(double time) const {
    return settings_during(adaption_, period_at(time).name);
  }

  std::vector<LoadPeriod> periods_;
  AdaptiveTimeStepping adaption_;
  double no_multiplier_;  // the largest where none is given
  double multiplier_ = 1.0;
  std::int64_t n_cutbacks_ = 0;  // in a row
};

/// The schedule of a region of an implicit procedure. Errors: a period without TIME INCREMENT, NUMBER OF TIME
/// STEPS or TIME INCREMENT FUNCTION.
LoadSchedule make_load_schedule(const SimulationDefinition& definition, const Procedure& procedure,
                                const Region& region, Diagnostics& diagnostics);

}  // namespace contactsim
