// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/base/diagnostics.hpp"
#include "core/definition/output_schedule.hpp"

namespace contactsim {

/// The schedule of an output with that of the scheduler which it uses; what both ask for adds up. A scheduler
/// that the deck does not define is an error.
OutputSchedule resolve_schedule(const OutputSchedule& schedule, std::span<const OutputScheduler> schedulers,
                                Diagnostics& diagnostics);

/// A state between two steps, as schedules see it.
struct OutputTime {
  std::int64_t step = 0;
  double time = 0.0;  ///< [time]
  bool is_last = false;
};

/// Says which states an output writes: the first one that reaches or passes a scheduled time or step, and the
/// last one. A time counts as reached when the difference is rounding. Without any line the schedule is
/// `default_step_increment`. Source: Sierra/SM 5.22, 9.2.
class OutputTimes {
 public:
  ///   default_step_increment  when the schedule says nothing; 0: only the first state and the last
  OutputTimes(OutputSchedule schedule, std::int64_t default_step_increment);

  /// Whether the state is due; asked in order of time. A step is due once, however often it is asked for.
  bool is_due(const OutputTime& now);

  /// The next scheduled time after `time`, if steps are to be stretched to hit it: TIMESTEP ADJUSTMENT
  /// INTERVAL. Nothing when no time follows.
  std::optional<double> next_time(double time) const;

  /// Number of steps over which they may be stretched; absent: they may not.
  std::optional<std::int64_t> adjustment_interval() const { return schedule_.adjustment_interval; }

 private:
  bool is_in_window(double time) const;
  std::int64_t count_times(double time) const;
  std::int64_t count_steps(std::int64_t step) const;

  OutputSchedule schedule_;                 // phases in order of their starts
  std::int64_t n_times_ = 0, n_steps_ = 0;  // scheduled up to the last state
  std::optional<std::int64_t> last_due_;    // step
};

}  // namespace contactsim
