// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/run/checkpoint.hpp"
#include "app/run/run_input.hpp"
#include "core/base/saved_state.hpp"
#include "core/dynamics/time_step.hpp"
#include "core/output/output_times.hpp"
#include "io/restart/restart_database.hpp"

namespace contactsim {

/// BEGIN RESTART DATA and the lines on restart at Sierra scope: the state that a run resumes from, and those
/// that it stores. Source: Sierra/SM 5.22, 9.9.
class RunRestart {
 public:
  /// What cannot be done is an error.
  ///   ranks  must outlive it
  RunRestart(const RunInput& input, Ranks& ranks, Diagnostics& diagnostics);

  /// Finds the state that the deck asks for, and from then on is a run that resumes. A damaged file is passed
  /// over for the next older one with a warning.
  ///   outputs  that the run is to write, whose files of earlier runs must be kept
  /// Throws FileError when there is none and the deck does not allow that.
  void find_state(const std::vector<std::string>& outputs, Diagnostics& warnings);
  /// The state that find_state() would take first; absent where there is none, or the deck asks for none.
  std::optional<StoredState> find_best() const;
  /// How far a state is from the time that the deck asks for, 0 where it asks for the latest [time].
  double distance_to(const StoredState& state) const;
  /// From now on it is a run that begins at its start: of several procedures another one resumes.
  void begin_at_start() { resumes_ = false; }
  /// The state to resume from; null when the run begins at its start.
  const SavedState* earlier() const { return earlier_ ? &*earlier_ : nullptr; }
  /// Whether its time becomes the start time of the run: SHIFT TO START TIME.
  bool shifts() const { return shifts_; }
  /// It has been restored.
  void forget_earlier() { earlier_.reset(); }
  /// What files of this run have at the end of their names.
  std::string suffix() const { return run_suffix(run_); }

  /// The time at which it wants a step to end, if it does.
  std::optional<StepTarget> step_target() const;
  /// The run begins with a state that needs no file.
  void begin(const State& state);
  /// Whether a state is due, or wanted, and was not written yet. To be called once a step.
  ///   is_last  the run ends with it
  bool is_due(const State& state, bool is_last, bool is_wanted);
  /// Writes a state. Throws FileError.
  void store(const Checkpoint& checkpoint);
  bool stores() const { return times_.has_value(); }

  /// Whether the deck asks for a state to resume from, and the database where it may be.
  bool resumes() const { return resumes_; }
  const std::string& input() const { return input_; }
  /// The one that was found.
  const std::optional<StoredState>& source() const { return source_; }
  /// Whether no run that began later has stored states in the database.
  bool is_of_latest_run() const { return is_of_latest_run_; }
  /// RESTART TIME. Precondition: the deck asks for one [time].
  double time() const { return *time_; }
  /// What was written; the last step is absent when nothing was.
  std::int64_t n_written() const { return n_written_; }
  std::optional<std::int64_t> last_step() const { return last_step_; }
  const std::string& last_path() const { return last_path_; }

 private:
  std::vector<StoredState> stored_states(Diagnostics& warnings) const;
  void check_overwriting() const;
  bool is_due(const State& state, bool is_last);
  void choose_run(const std::vector<std::string>& outputs);

  Ranks& ranks_;
  std::string input_, output_;                     // databases
  std::optional<double> time_;                     // of the state to resume from [time]
  bool resumes_ = false;                           // if there is a state
  bool is_optional_ = false;                       // that there is one
  bool shifts_ = false;                            // SHIFT TO START TIME
  bool overwrites_ = true;                         // states of other runs from the start
  std::optional<OutputTimes> times_, wall_times_;  // absent: nothing is stored
  double clock_begun_ = 0.0;                       // [s]
  RestartSlots slots_{0, std::nullopt};
  std::int64_t begun_ = 0, run_ = 1;
  bool is_of_latest_run_ = true;
  std::optional<StoredState> source_;
  std::optional<SavedState> earlier_;
  std::string last_path_;
  std::optional<std::int64_t> last_step_;
  std::int64_t n_written_ = 0;
};

/// Warns of a state that is not what the deck asks for ("restart-time"), of an earlier run ("restart-run"),
/// at the end of the run ("restart-over"), and of what has changed since ("restart-changed"). Precondition:
/// the run goes on from a state.
void warn_of_restart(const RunRestart& restart, std::span<const RunMark> changed, bool is_over,
                     Diagnostics& warnings);

}  // namespace contactsim
