// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/definition/condition_lines.hpp"
#include "core/definition/time_control.hpp"

namespace contactsim {

/// The times at which a condition acts: from the start of a period on, up to the start of the next.
class ActiveTimes {
 public:
  struct Interval {
    double begin = -std::numeric_limits<double>::infinity();  ///< [time]
    double end = std::numeric_limits<double>::infinity();     ///< the first time after it [time]
    bool operator==(const Interval&) const = default;
  };

  /// Always.
  ActiveTimes() : intervals_{Interval{}} {}
  /// intervals  ascending, none of them empty
  explicit ActiveTimes(std::vector<Interval> intervals) : intervals_(std::move(intervals)) {}

  bool is_active(double time) const;
  /// Whether some time belongs to both.
  bool overlaps(const ActiveTimes& other) const;
  std::span<const Interval> intervals() const { return intervals_; }
  bool operator==(const ActiveTimes&) const = default;

 private:
  std::vector<Interval> intervals_;
};

/// The times that ACTIVE PERIODS and INACTIVE PERIODS leave. The first period reaches back to the beginning,
/// the last goes on for ever. Without periods a condition always acts.
///   time_stepping_blocks  the periods, start times rise
/// Source: Sierra/SM 5.22, 3.1: time stepping blocks are the periods.
ActiveTimes make_active_times(const ActivePeriods& periods,
                              std::span<const TimeSteppingBlock> time_stepping_blocks);

}  // namespace contactsim
