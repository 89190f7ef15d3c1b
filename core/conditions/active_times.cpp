// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/active_times.hpp"

#include <algorithm>

namespace contactsim {

namespace {

bool contains(const std::vector<DeckName>& names, const DeckName& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_active(const ActivePeriods& periods, const DeckName& block) {
  return (periods.active.empty() || contains(periods.active, block)) && !contains(periods.inactive, block);
}

}  // namespace

bool ActiveTimes::is_active(double time) const {
  return std::any_of(intervals_.begin(), intervals_.end(),
                     [time](const Interval& i) { return i.begin <= time && time < i.end; });
}

bool ActiveTimes::overlaps(const ActiveTimes& other) const {
  return std::any_of(intervals_.begin(), intervals_.end(), [&](const Interval& mine) {
    return std::any_of(other.intervals_.begin(), other.intervals_.end(), [&](const Interval& theirs) {
      return mine.begin < theirs.end && theirs.begin < mine.end;
    });
  });
}

ActiveTimes make_active_times(const ActivePeriods& periods,
                              std::span<const TimeSteppingBlock> time_stepping_blocks) {
  if (periods.active.empty() && periods.inactive.empty()) return {};
  std::vector<ActiveTimes::Interval> intervals;
  for (std::size_t i = 0; i < time_stepping_blocks.size(); ++i) {
    if (!is_active(periods, time_stepping_blocks[i].name)) continue;
    ActiveTimes::Interval interval;
    if (i > 0) interval.begin = time_stepping_blocks[i].start_time;
    if (i + 1 < time_stepping_blocks.size()) interval.end = time_stepping_blocks[i + 1].start_time;
    const bool continues = !intervals.empty() && intervals.back().end == interval.begin;
    if (continues) {
      intervals.back().end = interval.end;
    } else {
      intervals.push_back(interval);
    }
  }
  return ActiveTimes(std::move(intervals));
}

}  // namespace contactsim
